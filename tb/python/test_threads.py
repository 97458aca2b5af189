# SPDX-License-Identifier: MIT
"""Bodies are used after deletion and from many threads; the lock of Python is released."""
import concurrent.futures
import gc
import signal
import threading
import time
import unittest

import numpy as np
import sepax
from sepax._library import core

from shapes import ball, cube, poses


class Threads(unittest.TestCase):
    """Many threads, and objects that others still use."""

    def test_shared(self):
        """Threads share bodies, also while their shells are found first."""
        a, b = sepax.Body(*ball(300)), sepax.Body(*cube(0.3))
        path = poses(200, 1.5)
        want = sepax.collide(sepax.Body(*ball(300)), b, path).codes
        distances = sepax.distance(a, b, path).value

        def ask(n):
            got = sepax.collide(a, b, path, threads=1 + n % 3).codes
            near = sepax.distance(a, b, path, threads=1).value
            return (got == want).all() and (near == distances).all() and a.shell().closed
        with concurrent.futures.ThreadPoolExecutor(8) as pool:
            self.assertTrue(all(pool.map(ask, range(24))))

    def test_deleted(self):
        """A body that is deleted while threads use it lives until they end."""
        def ask(n):
            a, b = sepax.Body(*ball(200, 1, n)), sepax.Body(*cube(0.4))
            path = poses(400, 1.5, n)
            handles = [(a._handle, b._handle)]
            result = []
            thread = threading.Thread(target=lambda: result.append(
                sepax.collide(a, b, path, threads=2)))
            thread.start()
            del handles, b
            gc.collect()
            thread.join()
            return len(result[0])
        self.assertEqual([ask(n) for n in range(8)], [400] * 8)

    def test_parts_outlive_names(self):
        """A shell keeps its body, and a machine its bodies and mechanism."""
        shells = [core.shell_new(sepax.Body(*ball(200, 1, n))._handle) for n in range(5)]
        gc.collect()
        self.assertTrue(all(core.shell_about(shell)[0] for shell in shells))
        joint = sepax.Joint("x", "prismatic", "a", "b", axis=(1, 0, 0))
        m = sepax.Mechanism(["a", "b"], [joint], pairs=[("a", "b")],
                            bodies={"a": sepax.Body(*ball(200)), "b": sepax.Body(*cube(0.2))})
        m.bodies.clear()
        m._handle = None
        gc.collect()
        self.assertEqual(m.check([[0.0], [9.0]]).collides.tolist(), [True, False])
        contact = None
        manager = sepax.CollisionManager()
        vertices, faces = cube()

        class Mesh:  # pylint: disable=too-few-public-methods
            """A mesh that nothing keeps."""
        mesh = Mesh()
        mesh.vertices, mesh.faces = vertices, faces
        manager.add_object("a", mesh)
        manager.add_object("b", mesh)
        contact = manager.in_collision_internal(return_data=True)[1][0]
        del manager, mesh
        gc.collect()
        self.assertEqual(contact.point.shape, (3,))

    def test_lock_is_released(self):
        """Another thread runs while one asks."""
        a, b = sepax.Body(*ball(3000, 1, 1)), sepax.Body(*ball(3000, 1.2, 2))
        path = poses(4000, 0.4)
        steps = []

        def count():
            while not done.is_set():
                steps.append(time.monotonic())
                time.sleep(0.001)
        done = threading.Event()
        thread = threading.Thread(target=count)
        thread.start()
        begin = time.monotonic()
        sepax.distance(a, b, path, threads=1, seconds=0.001)
        end = time.monotonic()
        done.set()
        thread.join()
        within = [s for s in steps if begin < s < end]
        self.assertGreater(len(within), 3)

    def test_signal(self):
        """Ctrl-C ends a long call."""
        a, b = sepax.Body(*ball(8000, 1, 1)), sepax.Body(*ball(8000, 1.001, 2))
        path = np.tile(np.eye(4), (200000, 1, 1))

        def stop(*_):
            raise KeyboardInterrupt
        before = signal.signal(signal.SIGALRM, stop)
        signal.setitimer(signal.ITIMER_REAL, 0.3)
        begin = time.monotonic()
        try:
            with self.assertRaises(KeyboardInterrupt):
                sepax.distance(a, b, path, seconds=0.01)
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
            signal.signal(signal.SIGALRM, before)
        self.assertLess(time.monotonic() - begin, 20)


if __name__ == "__main__":
    unittest.main()
