"""The onset of sliding as one program of array operations, for accelerators, with the equations of ``screening`` in Rust. A scene is one grasp.

Every function takes an array namespace ``xp``: ``jax.numpy``, ``torch`` or ``numpy``. This package imports none of them.
"""
