from dalembert._core_items import *
from dalembert._names import copy as copy
from dalembert._names import exu as exu
from dalembert._names import exudyn as exudyn
from dalembert._names import np as np

def IIDiagMatrix(rowsColumns: int, value: float) -> list[list[float]]: ...
