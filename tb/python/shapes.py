# SPDX-License-Identifier: MIT
"""Meshes and poses of the tests of the Python packages."""
import numpy as np

FACES = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
CORNERS = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], float)
CUBE_FACES = np.array([[0, 1, 3], [0, 3, 2], [4, 7, 5], [4, 6, 7], [0, 5, 1], [0, 4, 5],
                       [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]])


def cube(side=1.0, at=(0, 0, 0)):
    """The vertices and faces of a cube about a point."""
    corners = np.array([[x, y, z] for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)], float)
    return corners * (side / 2) + np.asarray(at, float), CUBE_FACES


def ball(count=400, radius=1.0, seed=1):
    """A closed mesh near a sphere: rings of points, with a little noise."""
    rng = np.random.default_rng(seed)
    rings = max(3, int(np.sqrt(count / 4)))
    round_ = 2 * rings
    points = [[0, 0, radius]]
    for k in range(1, rings):
        angle = np.pi * k / rings
        for n in range(round_):
            turn = 2 * np.pi * n / round_
            points.append([radius * np.sin(angle) * np.cos(turn),
                           radius * np.sin(angle) * np.sin(turn), radius * np.cos(angle)])
    points.append([0, 0, -radius])
    faces = []
    last = len(points) - 1
    for n in range(round_):
        after = (n + 1) % round_
        faces.append([0, 1 + n, 1 + after])
        for k in range(rings - 2):
            a, b = 1 + k * round_, 1 + (k + 1) * round_
            faces += [[a + n, b + n, b + after], [a + n, b + after, a + after]]
        faces.append([last, 1 + (rings - 2) * round_ + after, 1 + (rings - 2) * round_ + n])
    points = np.array(points)
    return points * (1 + 0.02 * rng.random((len(points), 1))), np.array(faces)


def poses(count, reach, seed=1):
    """Random rotations and translations of up to `reach`."""
    rng = np.random.default_rng(seed)
    q = rng.normal(size=(count, 4))
    w, x, y, z = (q / np.linalg.norm(q, axis=1, keepdims=True)).T
    result = np.zeros((count, 4, 4))
    result[:, 0, :3] = np.stack([1 - 2 * (y * y + z * z), 2 * (x * y - w * z),
                                 2 * (x * z + w * y)], axis=1)
    result[:, 1, :3] = np.stack([2 * (x * y + w * z), 1 - 2 * (x * x + z * z),
                                 2 * (y * z - w * x)], axis=1)
    result[:, 2, :3] = np.stack([2 * (x * z - w * y), 2 * (y * z + w * x),
                                 1 - 2 * (x * x + y * y)], axis=1)
    result[:, :3, 3] = rng.uniform(-reach, reach, (count, 3))
    result[:, 3, 3] = 1
    return result


def at(x=0.0, y=0.0, z=0.0):
    """A translation."""
    pose = np.eye(4)
    pose[:3, 3] = x, y, z
    return pose
