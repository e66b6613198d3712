"""Scenarios as environments of Gymnasium: importing this registers "dampen/Beam-v0".

    import gymnasium, dampen.gym
    env = gymnasium.make("dampen/Beam-v0", scenario="he2017")
    many = gymnasium.make_vec("dampen/Beam-v0", num_envs=64, vectorization_mode="vector_entry_point", scenario="he2017")

Needs gymnasium: `pip install 'dampen[gym]'`.
"""

try:
    import gymnasium
except ImportError:
    raise ImportError("`dampen.gym` needs gymnasium: pip install 'dampen[gym]'.") from None

from dampen.gym.environment import BeamEnv as BeamEnv
from dampen.gym.vector import BeamVectorEnv as BeamVectorEnv

ID = "dampen/Beam-v0"
if ID not in gymnasium.registry:
    gymnasium.register(
        id=ID, entry_point="dampen.gym.environment:BeamEnv", vector_entry_point="dampen.gym.vector:BeamVectorEnv"
    )  # fmt: skip
