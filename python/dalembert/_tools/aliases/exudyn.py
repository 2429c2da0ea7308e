"""Target of `import exudyn` in processes that a model starts: they inherit its paths, but not its aliases."""

import sys

from dalembert import alias

# A file that is loaded separately, under any name, is not an alias.
if __name__ == "exudyn":
    del sys.modules[__name__]
    alias.install(__name__)
