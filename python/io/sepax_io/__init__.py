# SPDX-License-Identifier: MIT
"""sepax_io: readers of sepax that need libraries. `import sepax` finds them by itself."""
