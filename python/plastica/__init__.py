"""Plastica: lumped beams, simulated and calibrated.

>>> import plastica
>>> scene = plastica.Scene.from_toml("scene.toml")
>>> response = plastica.simulate(scene)
>>> response.probes["tip"]
"""

try:
    from ._core import __version__
except ImportError as error:
    raise ImportError(
        "the engine of plastica is not beside this folder of its sources: `pip install .` in the clone "
        "puts both together, and PYTHONPATH=build/release/python finds what a build has"
    ) from error
from .errors import InputError, SceneWarning
from .fields import Beam, Hardening, Material, Rate, Rules, Section, Solver
from .files import load
from .fit import fit
from .fits import Fits
from .fitted import Fit, Parameter
from .items import (
    Cut,
    Drive,
    InitialMotion,
    Load,
    PointMass,
    Probe,
    Region,
    Support,
    cycles,
    turning_points,
)
from .model import Batch, Model, Sensitivity, prepare, simulate
from .problem import Problem, problem
from .response import Response, Simulation
from .scene import Scene
from .scene_fit import BeamTest, fit_scenes
from .studies import Advice, Claim, JudgedNumber, Sweep, advise, check, export, sweep

__all__ = [
    "Advice", "Batch", "Beam", "BeamTest", "Claim", "Cut", "Drive", "Fit", "Fits", "Hardening",
    "InitialMotion", "InputError", "JudgedNumber", "Load", "Material", "Model", "Parameter",
    "PointMass", "Probe", "Problem", "Rate", "Region", "Response", "Rules", "Scene", "SceneWarning",
    "Section", "Sensitivity", "Simulation", "Solver", "Support", "Sweep", "__version__", "advise",
    "check", "cycles", "export", "fit", "fit_scenes", "load", "prepare", "problem", "simulate",
    "sweep", "turning_points",
]
