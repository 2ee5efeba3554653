# SPDX-License-Identifier: MIT
"""A headless Chromium with one page, and the queries of the tests."""
from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.keys import Keys

# Texts wider than their box, and parts that reach beyond the page, except in boxes that scroll.
OVERFLOWS = """
const scrolls = (e) => e && (/auto|scroll/.test(getComputedStyle(e).overflowX) || scrolls(e.parentElement));
const found = [];
const width = document.documentElement.clientWidth;
if (document.documentElement.scrollWidth > width) {
  found.push(`the page is ${document.documentElement.scrollWidth} wide on a screen of ${width}`);
}
for (const e of document.querySelectorAll("body *")) {
  if (["SCRIPT", "STYLE"].includes(e.tagName) || scrolls(e) || !e.clientWidth) { continue; }
  const right = e.getBoundingClientRect().right;
  if (e.scrollWidth > e.clientWidth + 1 || right > width + 1) {
    found.push(`${e.tagName} ${e.id || e.className} (${e.scrollWidth} in ${e.clientWidth}, ends at ` +
               `${Math.round(right)}): ${e.textContent.slice(0, 60)}`);
  }
}
return found;"""

# Texts that are too small or too pale: WCAG 2 requires a contrast of 4.5 to 1.
UNREADABLE = """
const numbers = (c) => (c.match(/[\\d.]+/g) || []).map(Number);
const ground = (e) => {
  for (; e; e = e.parentElement) {
    const c = numbers(getComputedStyle(e).backgroundColor);
    if (c.length === 3 || c[3] > 0) { return c; }
  }
  return [255, 255, 255];
};
const light = (c) => c.slice(0, 3).map((v) => v / 255)
  .map((v) => v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4)
  .reduce((sum, v, k) => sum + v * [0.2126, 0.7152, 0.0722][k], 0);
const found = [];
for (const e of document.querySelectorAll("main *, header *, nav *, footer *")) {
  const own = Array.from(e.childNodes).some((n) => n.nodeType === 3 && n.textContent.trim());
  if (!own || !e.getClientRects().length) { continue; }
  const look = getComputedStyle(e);
  const [a, b] = [light(numbers(look.color)), light(ground(e))].sort((x, y) => y - x);
  const contrast = (a + 0.05) / (b + 0.05);
  if (parseFloat(look.fontSize) < 12 || contrast < 4.5) {
    found.push(`${e.tagName} ${e.className} ${look.fontSize}, ${contrast.toFixed(2)} to 1: ` +
               e.textContent.slice(0, 60));
  }
}
return found;"""

# The element with the focus, its index in the order of the document, and whether the focus is visible.
FOCUS = """
const e = document.activeElement;
if (!e || e === document.body) { return null; }
const look = getComputedStyle(e);
const able = Array.from(document.querySelectorAll(
  "a[href], button, summary, [tabindex='0']")).filter((x) => x.checkVisibility());
return {place: able.indexOf(e), count: able.length, name: e.tagName + " " + e.textContent.slice(0, 40),
        seen: look.outlineStyle !== "none" && parseFloat(look.outlineWidth) >= 2};"""


class Browser:
    def __init__(self, driver="chromedriver", program="chromium"):
        options = webdriver.ChromeOptions()
        options.binary_location = program
        for word in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage",
                     "--allow-file-access-from-files", "--hide-scrollbars"):
            options.add_argument(word)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        self.driver = webdriver.Chrome(service=Service(driver), options=options)

    def close(self):
        self.driver.quit()

    def show(self, path, width=1000, dark=False):
        """Opens a file without a network."""
        self.driver.execute_cdp_cmd("Network.enable", {})
        self.driver.execute_cdp_cmd("Network.emulateNetworkConditions", {
            "offline": True, "latency": 0, "downloadThroughput": 0, "uploadThroughput": 0})
        self.resize(width, dark)
        self.driver.get("about:blank")  # a change of the fragment alone would not reload the page
        name, mark, fragment = path.partition("#")
        self.driver.get("file://" + name + mark + fragment)

    def resize(self, width, dark):
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": width, "height": 900, "deviceScaleFactor": 1, "mobile": False})
        self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [
            {"name": "prefers-color-scheme", "value": "dark" if dark else "light"}]})

    def ask(self, script, *words):
        return self.driver.execute_script(script, *words)

    def unfold(self):
        self.ask("document.querySelectorAll('details').forEach((d) => { d.open = true; });")

    def errors(self):
        return [entry["message"] for entry in self.driver.get_log("browser")
                if entry["level"] in ("SEVERE", "WARNING")]

    def press(self, key):
        self.driver.switch_to.active_element.send_keys(key)

    def tab(self):
        """Moves the focus to the next element and returns its position."""
        self.press(Keys.TAB)
        return self.ask(FOCUS)
