# RV32: there is no store-multiple, so unrolled word stores.

# bound_fill(a0 = first word, a1 = end, a2 = value): a multiple of 16 words.
    .section .text.bound_fill, "ax", @progbits
    .global bound_fill
    .type bound_fill, @function
bound_fill:
1:  sw    a2, 0(a0)
    sw    a2, 4(a0)
    sw    a2, 8(a0)
    sw    a2, 12(a0)
    sw    a2, 16(a0)
    sw    a2, 20(a0)
    sw    a2, 24(a0)
    sw    a2, 28(a0)
    sw    a2, 32(a0)
    sw    a2, 36(a0)
    sw    a2, 40(a0)
    sw    a2, 44(a0)
    sw    a2, 48(a0)
    sw    a2, 52(a0)
    sw    a2, 56(a0)
    sw    a2, 60(a0)
    addi  a0, a0, 64
    bltu  a0, a1, 1b
    ret

# bound_rect(a0 = first pixel, a1 = value twice, a2 = width, a3 = rows, a4 = stride in bytes):
# 16-bit pixels; a halfword up to the first whole word, 16 pixels at a time, then what is left.
    .section .text.bound_rect, "ax", @progbits
    .global bound_rect
    .type bound_rect, @function
bound_rect:
    li    t3, 16
1:  mv    t0, a0
    mv    t1, a2
    andi  t2, a0, 2
    beqz  t2, 2f
    sh    a1, 0(t0)
    addi  t0, t0, 2
    addi  t1, t1, -1
2:  bltu  t1, t3, 4f
3:  sw    a1, 0(t0)
    sw    a1, 4(t0)
    sw    a1, 8(t0)
    sw    a1, 12(t0)
    sw    a1, 16(t0)
    sw    a1, 20(t0)
    sw    a1, 24(t0)
    sw    a1, 28(t0)
    addi  t0, t0, 32
    addi  t1, t1, -16
    bgeu  t1, t3, 3b
4:  andi  t2, t1, 8
    beqz  t2, 5f
    sw    a1, 0(t0)
    sw    a1, 4(t0)
    sw    a1, 8(t0)
    sw    a1, 12(t0)
    addi  t0, t0, 16
5:  andi  t2, t1, 4
    beqz  t2, 6f
    sw    a1, 0(t0)
    sw    a1, 4(t0)
    addi  t0, t0, 8
6:  andi  t2, t1, 2
    beqz  t2, 7f
    sw    a1, 0(t0)
    addi  t0, t0, 4
7:  andi  t2, t1, 1
    beqz  t2, 8f
    sh    a1, 0(t0)
8:  add   a0, a0, a4
    addi  a3, a3, -1
    bnez  a3, 1b
    ret

# bound_column(a0 = first pixel, a1 = value, a2 = rows): 16-bit pixels, rows of 640 bytes, a multiple
# of 6 rows. Offsets reach 2,047 bytes: the address is kept two rows down.
    .section .text.bound_column, "ax", @progbits
    .global bound_column
    .type bound_column, @function
bound_column:
    addi  a0, a0, 1280
    li    t0, 3840
1:  sh    a1, -1280(a0)
    sh    a1, -640(a0)
    sh    a1, 0(a0)
    sh    a1, 640(a0)
    sh    a1, 1280(a0)
    sh    a1, 1920(a0)
    add   a0, a0, t0
    addi  a2, a2, -6
    bnez  a2, 1b
    ret
