"""Boundary control and iterative learning control of vibrating structures."""

from dampen.actuators.backlash import Backlash as Backlash
from dampen.actuators.ideal import Ideal as Ideal
from dampen.component import ArgumentError as ArgumentError
from dampen.controllers.base import Controller as Controller
from dampen.controllers.base import PortLaw as PortLaw
from dampen.controllers.dual_loop_ailc import AssumedBacklash as AssumedBacklash
from dampen.controllers.dual_loop_ailc import DualLoopAILC as DualLoopAILC
from dampen.controllers.none import NoControl as NoControl
from dampen.disturbances.base import Disturbance as Disturbance
from dampen.disturbances.harmonic_families import HarmonicFamilies as HarmonicFamilies
from dampen.disturbances.none import NoDisturbance as NoDisturbance
from dampen.plants.base import Modes as Modes
from dampen.plants.base import Plant as Plant
from dampen.plants.timoshenko import BeamState as BeamState
from dampen.plants.timoshenko import TimoshenkoBeam as TimoshenkoBeam
from dampen.scenarios.claims import check_claims as check_claims
from dampen.scenarios.read import read_scenario as read_scenario
from dampen.scenarios.results import load as load
from dampen.simulation.result import Result as Result
from dampen.simulation.scenario import Numerics as Numerics
from dampen.simulation.scenario import Output as Output
from dampen.simulation.scenario import Scenario as Scenario
from dampen.simulation.scenario import Task as Task
from dampen.simulation.trials import simulate as simulate
from dampen.version import version as version
