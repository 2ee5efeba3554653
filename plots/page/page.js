// SPDX-License-Identifier: MIT
// Sorts tables by the button in a column's head, and opens a folded part when a link leads into it.
"use strict";

function valueOf(row, column) {
  const cell = row.cells[column];
  return "v" in cell.dataset ? Number(cell.dataset.v) : cell.textContent.trim();
}

// Cells without a number go last in either direction.
function compare(a, b, sign) {
  if (typeof a === "number" && typeof b === "number") {
    return Number.isNaN(a) - Number.isNaN(b) || sign * (a - b);
  }
  return sign * String(a).localeCompare(String(b), "en", { numeric: true });
}

function sortBy(head) {
  const body = head.closest("table").tBodies[0];
  const direction = head.getAttribute("aria-sort") === "ascending" ? "descending" : "ascending";
  for (const other of head.parentElement.cells) {
    other.setAttribute("aria-sort", other === head ? direction : "none");
  }
  const sign = direction === "ascending" ? 1 : -1;
  const rows = Array.from(body.rows);
  rows.sort((a, b) => compare(valueOf(a, head.cellIndex), valueOf(b, head.cellIndex), sign));
  body.append(...rows);
}

function openTarget() {
  const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  for (let part = target; part; part = part.parentElement) {
    if (part.tagName === "DETAILS") {
      part.open = true;
    }
  }
  if (target) {
    target.scrollIntoView();
  }
}

document.addEventListener("click", (event) => {
  const button = event.target.closest("th button");
  if (button) {
    sortBy(button.closest("th"));
  }
});
addEventListener("hashchange", openTarget);
if (location.hash) {
  openTarget();
}
