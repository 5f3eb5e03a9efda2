@ Cortex-M0+: store-multiples of low registers, conditional branches in place of IT blocks.

    .syntax unified
    .thumb

@ bound_fill(r0 = first word, r1 = end, r2 = value): a multiple of 48 words.
    .section .text.bound_fill, "ax", %progbits
    .global bound_fill
    .type bound_fill, %function
    .thumb_func
bound_fill:
    push  {r4-r7, lr}
    mov   r3, r2
    mov   r4, r2
    mov   r5, r2
    mov   r6, r2
    mov   r7, r2
1:  stmia r0!, {r2-r7}
    stmia r0!, {r2-r7}
    stmia r0!, {r2-r7}
    stmia r0!, {r2-r7}
    stmia r0!, {r2-r7}
    stmia r0!, {r2-r7}
    stmia r0!, {r2-r7}
    stmia r0!, {r2-r7}
    cmp   r0, r1
    blo   1b
    pop   {r4-r7, pc}

@ bound_rect(r0 = first pixel, r1 = value twice, r2 = width, r3 = rows, [sp] = stride in bytes):
@ 16-bit pixels; a halfword up to the first whole word, 8 pixels at a time, then what is left.
@ r8 = stride, r9 = rows, r10 = start of the row.
    .section .text.bound_rect, "ax", %progbits
    .global bound_rect
    .type bound_rect, %function
    .thumb_func
bound_rect:
    push  {r4-r7, lr}
    mov   r4, r8
    mov   r5, r9
    mov   r6, r10
    push  {r4-r6}
    ldr   r4, [sp, #32]
    mov   r8, r4
    mov   r9, r3
    mov   r10, r0
    mov   r4, r1
    mov   r5, r1
    mov   r6, r1
1:  mov   r0, r10
    mov   r3, r2
    lsls  r7, r0, #30
    bpl   2f
    strh  r1, [r0]
    adds  r0, r0, #2
    subs  r3, r3, #1
2:  subs  r3, r3, #8
    blo   4f
3:  stmia r0!, {r1, r4-r6}
    subs  r3, r3, #8
    bhs   3b
4:  lsls  r7, r3, #30
    bcc   5f
    stmia r0!, {r1, r4}
5:  bpl   6f
    stmia r0!, {r1}
6:  lsls  r7, r3, #31
    bpl   7f
    strh  r1, [r0]
7:  add   r10, r8
    mov   r7, r9
    subs  r7, r7, #1
    mov   r9, r7
    bne   1b
    pop   {r4-r6}
    mov   r8, r4
    mov   r9, r5
    mov   r10, r6
    pop   {r4-r7, pc}

@ bound_column(r0 = first pixel, r1 = value, r2 = rows): 16-bit pixels, rows of 640 bytes, a multiple
@ of 6 rows. r3 to r7 = one to five rows, and one more is added in two steps.
    .section .text.bound_column, "ax", %progbits
    .global bound_column
    .type bound_column, %function
    .thumb_func
bound_column:
    push  {r4-r7, lr}
    movs  r3, #5
    lsls  r3, r3, #7
    adds  r4, r3, r3
    adds  r5, r4, r3
    adds  r6, r5, r3
    adds  r7, r6, r3
1:  strh  r1, [r0]
    strh  r1, [r0, r3]
    strh  r1, [r0, r4]
    strh  r1, [r0, r5]
    strh  r1, [r0, r6]
    strh  r1, [r0, r7]
    adds  r0, r0, r7
    adds  r0, r0, r3
    subs  r2, r2, #6
    bne   1b
    pop   {r4-r7, pc}
