"""The onset of sliding as one program of array operations, for accelerators: the mathematics of ``screening`` in Rust, scene by scene.

Every function takes a namespace of arrays ``xp``: ``jax.numpy``, ``torch`` or ``numpy``. None of them is imported here.
"""
