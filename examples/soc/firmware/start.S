# SPDX-License-Identifier: MIT
# start.S - where the CPU begins: the stack is set by the hardware; the program ends at END.
  .section .text.start
  .globl _start
_start:
  lui sp, %hi(stack_top)
  addi sp, sp, %lo(stack_top)
  call main
  lui t0, 0x10000
  sw a0, 4(t0)
1:
  j 1b
