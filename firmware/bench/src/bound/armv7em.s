@ Cortex-M4: eight words to a store-multiple.

    .syntax unified
    .thumb

@ bound_fill(r0 = first word, r1 = end, r2 = value): a multiple of 32 words, at least 64.
    .section .text.bound_fill, "ax", %progbits
    .global bound_fill
    .type bound_fill, %function
    .thumb_func
bound_fill:
    push  {r4-r10, lr}
    mov   r3, r2
    mov   r4, r2
    mov   r5, r2
    mov   r6, r2
    mov   r7, r2
    mov   r8, r2
    mov   r9, r2
    subs  r1, r1, #256
1:  stmia r0!, {r2-r9}
    stmia r0!, {r2-r9}
    stmia r0!, {r2-r9}
    stmia r0!, {r2-r9}
    stmia r0!, {r2-r9}
    stmia r0!, {r2-r9}
    stmia r0!, {r2-r9}
    stmia r0!, {r2-r9}
    cmp   r0, r1
    bls   1b
    add   r1, r1, #256
    cmp   r0, r1
    beq   2f
    stmia r0!, {r2-r9}
    stmia r0!, {r2-r9}
    stmia r0!, {r2-r9}
    stmia r0!, {r2-r9}
2:  pop   {r4-r10, pc}

@ bound_rect(r0 = first pixel, r1 = value twice, r2 = width, r3 = rows, [sp] = stride in bytes):
@ 16-bit pixels; a halfword up to the first whole word, 32 pixels at a time, then what is left.
    .section .text.bound_rect, "ax", %progbits
    .global bound_rect
    .type bound_rect, %function
    .thumb_func
bound_rect:
    push  {r4-r11, lr}
    ldr   r11, [sp, #36]
    mov   r4, r1
    mov   r5, r1
    mov   r6, r1
    mov   r7, r1
    mov   r8, r1
    mov   r9, r1
    mov   r10, r1
1:  mov   r12, r0
    mov   lr, r2
    tst   r0, #2
    beq   2f
    strh  r1, [r12], #2
    subs  lr, lr, #1
2:  subs  lr, lr, #32
    blo   4f
3:  stmia r12!, {r1, r4-r10}
    stmia r12!, {r1, r4-r10}
    subs  lr, lr, #32
    bhs   3b
4:  tst   lr, #16
    it    ne
    stmiane r12!, {r1, r4-r10}
    tst   lr, #8
    it    ne
    stmiane r12!, {r1, r4-r6}
    tst   lr, #4
    it    ne
    stmiane r12!, {r1, r4}
    tst   lr, #2
    it    ne
    strne r1, [r12], #4
    tst   lr, #1
    it    ne
    strhne r1, [r12]
    add   r0, r0, r11
    subs  r3, r3, #1
    bne   1b
    pop   {r4-r11, pc}

@ bound_column(r0 = first pixel, r1 = value, r2 = rows): 16-bit pixels, rows of 640 bytes, a multiple
@ of 6 rows.
    .section .text.bound_column, "ax", %progbits
    .global bound_column
    .type bound_column, %function
    .thumb_func
bound_column:
1:  strh  r1, [r0]
    strh  r1, [r0, #640]
    strh  r1, [r0, #1280]
    strh  r1, [r0, #1920]
    strh  r1, [r0, #2560]
    strh  r1, [r0, #3200]
    add   r0, r0, #3840
    subs  r2, r2, #6
    bne   1b
    bx    lr
