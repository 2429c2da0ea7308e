"""What `import exudyn` finds in processes that a model starts: they are given its paths, but not its aliases."""

import sys

from dalembert import alias

# A file that is loaded on its own, by whatever name, is no alias.
if __name__ == "exudyn":
    del sys.modules[__name__]
    alias.install(__name__)
