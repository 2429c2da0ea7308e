"""No parameter is accepted and ignored: changing it has an effect on forces, equations, the start, the update of data
coordinates or an output of a model, or it does not fit the model."""

from dalembert.testing.parameters_act import *  # noqa: F403
