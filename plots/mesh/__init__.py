# SPDX-License-Identifier: MIT
"""Pictures of meshes and of how their triangles are distributed, from dsc_scene."""
