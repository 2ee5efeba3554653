# SPDX-License-Identifier: MIT
"""Common parts of all pictures: palette, markers, layout, saving. A script run by a Python without
matplotlib ends here with one sentence, or with its help."""
import os
import sys

try:
    import matplotlib  # noqa: F401
except ImportError:
    if {"-h", "--help"} & set(sys.argv[1:]):
        print(sys.modules["__main__"].__doc__.strip())
        sys.exit(0)
    sys.stderr.write(f"{os.path.basename(sys.argv[0])}: {sys.executable} has no matplotlib; run it with "
                     "a Python that has (Debian: package python3-matplotlib and /usr/bin/python3).\n")
    sys.exit(2)
