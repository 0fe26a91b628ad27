"""A plugin of pytest for tests of other projects: puts Toccata in the place of what they test.

TOCCATA_IN_PLACE_OF says what of: `collision` (trimesh.collision becomes toccata.trimesh) or `fcl` (the module fcl becomes
toccata.fcl, for trimesh's own manager and for python-fcl's tests).
"""

import os
import sys

import toccata.fcl

sys.modules["fcl"] = toccata.fcl
if os.environ["TOCCATA_IN_PLACE_OF"] == "collision":
    import toccata.trimesh
    import trimesh

    trimesh.collision = toccata.trimesh
    sys.modules["trimesh.collision"] = toccata.trimesh
