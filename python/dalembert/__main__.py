"""python -m dalembert ... is the command dalembert."""

import sys

from dalembert.cli import main

# A file that is loaded separately, under any name, belongs to no package and must not run.
if __name__ == "__main__" and __package__:
    sys.exit(main())
