//! Pixel by pixel.

use bytemuck::{pod_align_to, pod_align_to_mut, Pod};

use crate::{
    num::cast::{low_u16, low_u8},
    pixel::format::{bytes_per_pixel, PixelFormat},
    tune::{keep_rolled, COMPACT, UNALIGNED, VECTORS},
};

/// Whether pixels are compared, or written, four at a time. Computers do more of them at once by
/// themselves.
const FOURS: bool = !VECTORS && !COMPACT;

/// Whether two bytes are one load only where their address is even, which is worth a look.
const HALVES: bool = !UNALIGNED && !COMPACT;

/// Writes the pixel at byte `at`.
#[inline(always)]
pub(in crate::pixel::rows) fn set<F: PixelFormat>(memory: &mut [u8], at: usize, bits: u32) {
    fn put<const N: usize>(memory: &mut [u8], at: usize, pixel: [u8; N]) {
        if let Some(place) = memory.get_mut(at..at.wrapping_add(N)).and_then(<[u8]>::first_chunk_mut) {
            *place = pixel;
        }
    }
    match F::BITS {
        8 => put(memory, at, [low_u8(bits)]),
        16 => put(memory, at, low_u16(bits).to_le_bytes()),
        24 => put(memory, at, three(bits)),
        _ => put(memory, at, bits.to_le_bytes()),
    }
}

/// Reads the pixel at byte `at`.
#[inline(always)]
pub(in crate::pixel::rows) fn get<F: PixelFormat>(memory: &[u8], at: usize) -> u32 {
    fn pixel<const N: usize>(memory: &[u8], at: usize) -> [u8; N] {
        // Without an end that might overflow: one addition and two registers less.
        let place = memory.get(at..).and_then(<[u8]>::first_chunk);
        place.copied().unwrap_or([0; N])
    }
    match F::BITS {
        8 => u32::from(pixel::<1>(memory, at)[0]),
        16 => u32::from(u16::from_le_bytes(pixel(memory, at))),
        24 => {
            let [a, b, c] = pixel(memory, at);
            u32::from_le_bytes([a, b, c, 0])
        }
        _ => u32::from_le_bytes(pixel(memory, at)),
    }
}

/// Pixel x of row y, where rows are whole pixels apart. It is found by its number: that is one comparison less than by its bytes, and
/// one product and sum where a chip has those in one.
#[inline(always)]
pub(in crate::pixel::rows) fn nth<const N: usize>(memory: &[u8], stride: usize, (x, y): (usize, usize)) -> [u8; N]
where
    [u8; N]: Pod,
{
    let (_, pixels, _) = pod_align_to::<u8, [u8; N]>(memory);
    match pixels.get(y.wrapping_mul(stride / N).wrapping_add(x)) {
        Some(&pixel) => pixel,
        None => beyond(),
    }
}

/// What a pixel beyond the memory reads as. It is told to be rare: so the loop around it goes on without a jump where there is a pixel.
#[cold]
const fn beyond<const N: usize>() -> [u8; N] {
    [0; N]
}

/// The low three bytes, the least significant one first.
#[inline(always)]
pub(in crate::pixel::rows) const fn three(bits: u32) -> [u8; 3] {
    let [a, b, c, _] = bits.to_le_bytes();
    [a, b, c]
}

/// Copies the pixels of a run that differ from `key`.
#[inline(always)]
pub(in crate::pixel::rows) fn copy_keyed<F: PixelFormat>(to: &mut [u8], from: &[u8], key: u32) {
    /// Whole pixels as numbers, one comparison for all of a pixel.
    #[inline(always)]
    fn copy<const N: usize, T: Copy + PartialEq>(
        (to, from): (&mut [u8], &[u8]),
        key: T,
        (number, bytes): (impl Fn([u8; N]) -> T, impl Fn(T) -> [u8; N]),
    ) where
        [u8; N]: Pod,
    {
        let (_, to, _) = pod_align_to_mut::<u8, [u8; N]>(to);
        let (_, from, _) = pod_align_to::<u8, [u8; N]>(from);
        let put = |place: &mut [u8; N], pixel: &[u8; N]| {
            let new = number(*pixel);
            if VECTORS {
                *place = bytes(if new == key { number(*place) } else { new });
            } else if new != key {
                *place = *pixel;
            }
        };
        let (mut to, mut from) = (to, from);
        if FOURS {
            // Written out, four pixels lie at fixed distances from one address.
            let (mut groups, mut sources) = (to.chunks_exact_mut(4), from.chunks_exact(4));
            for (places, pixels) in (&mut groups).zip(&mut sources) {
                if let ([a, b, c, d], [p, q, r, s]) = (places, pixels) {
                    put(a, p);
                    put(b, q);
                    put(c, r);
                    put(d, s);
                }
            }
            (to, from) = (groups.into_remainder(), sources.remainder());
        }
        to.iter_mut().zip(from).for_each(|(place, pixel)| put(place, pixel));
    }
    if HALVES && F::BITS == 16 {
        if let (([], to, []), ([], from, [])) = (pod_align_to_mut::<u8, u16>(to), pod_align_to::<u8, u16>(from)) {
            let key = low_u16(key).to_le();
            for (place, &pixel) in to.iter_mut().zip(from) {
                if pixel != key {
                    *place = pixel;
                }
            }
            return;
        }
    }
    let runs = (to, from);
    match F::BITS {
        8 => copy(runs, low_u8(key), (u8::from_le_bytes, u8::to_le_bytes)),
        16 => copy(runs, low_u16(key), (u16::from_le_bytes, u16::to_le_bytes)),
        24 => copy(runs, three(key), (|pixel| pixel, |pixel| pixel)),
        _ => copy(runs, key, (u32::from_le_bytes, u32::to_le_bytes)),
    }
}

/// Writes a run from left to right: what `next` gives. One store a pixel.
#[inline(always)]
pub(in crate::pixel::rows) fn write_all<F: PixelFormat>(run: &mut [u8], mut next: impl FnMut() -> u32) {
    match F::BITS {
        8 => in_fours(run, || low_u8(next())),
        16 => {
            if HALVES {
                if let ([], halves, []) = pod_align_to_mut::<u8, u16>(run) {
                    return in_fours(halves, || low_u16(next()).to_le());
                }
            }
            in_fours(pod_align_to_mut::<u8, [u8; 2]>(run).1, || low_u16(next()).to_le_bytes());
        }
        24 => in_fours(pod_align_to_mut::<u8, [u8; 3]>(run).1, || three(next())),
        _ => in_fours(pod_align_to_mut::<u8, [u8; 4]>(run).1, || next().to_le_bytes()),
    }
}

/// Writes pixels, on small cores four in a turn: one in a turn, the loop itself takes a fifth of the cycles of a shade.
#[inline(always)]
fn in_fours<T>(mut pixels: &mut [T], mut next: impl FnMut() -> T) {
    if FOURS {
        let mut fours = pixels.chunks_exact_mut(4);
        for four in &mut fours {
            let [a, b, c, d] = four else { break };
            keep_rolled(true);
            *a = next();
            *b = next();
            *c = next();
            *d = next();
        }
        pixels = fours.into_remainder();
    }
    for pixel in pixels {
        keep_rolled(FOURS);
        *pixel = next();
    }
}

/// Writes pixels in parts: see [`rows::write_parts`](crate::pixel::rows::write_parts).
#[inline(always)]
pub(in crate::pixel::rows) fn write_parts<F: PixelFormat, R: Copy>(
    pixels: &mut [u8],
    most: usize,
    run: R,
    mut go_on: impl FnMut(&mut R, usize),
    mut next: impl FnMut(&mut R) -> u32,
) {
    match F::BITS {
        8 => in_parts(pixels, most, run, go_on, |part, run| in_fours(part, || low_u8(next(run)))),
        // `go_on` is called at one place for even and odd addresses: at two, it would not be inlined. Twice the length of a part fits, as it
        // is shorter than a row.
        16 if HALVES => {
            let go_on = |run: &mut R, bytes: usize| go_on(run, bytes / 2);
            in_parts(pixels, most.wrapping_mul(2), run, go_on, |part, run| write_all::<F>(part, || next(run)));
        }
        16 => {
            let pixels = pod_align_to_mut::<u8, [u8; 2]>(pixels).1;
            in_parts(pixels, most, run, go_on, |part, run| in_fours(part, || low_u16(next(run)).to_le_bytes()));
        }
        24 => {
            let pixels = pod_align_to_mut::<u8, [u8; 3]>(pixels).1;
            in_parts(pixels, most, run, go_on, |part, run| in_fours(part, || three(next(run))));
        }
        _ => {
            let pixels = pod_align_to_mut::<u8, [u8; 4]>(pixels).1;
            in_parts(pixels, most, run, go_on, |part, run| in_fours(part, || next(run).to_le_bytes()));
        }
    }
}

/// The same for parts that `write` writes.
#[inline(always)]
fn in_parts<R: Copy, T>(
    mut pixels: &mut [T],
    most: usize,
    mut run: R,
    mut go_on: impl FnMut(&mut R, usize),
    mut write: impl FnMut(&mut [T], &mut R),
) {
    while let Some((part, rest)) = pixels.split_at_mut_checked(most.min(pixels.len())) {
        // A copy, which has registers.
        let mut at = run;
        write(part, &mut at);
        if rest.is_empty() {
            return;
        }
        run = at;
        go_on(&mut run, rest.len());
        pixels = rest;
    }
}

/// Writes a run from left to right: what `next` gives, or nothing where that is `None`. One store a pixel.
#[inline(always)]
pub(in crate::pixel::rows) fn write<F: PixelFormat>(run: &mut [u8], mut next: impl FnMut() -> Option<u32>) {
    match F::BITS {
        8 => write_each(run, || next().map(|bits| [low_u8(bits)])),
        16 => write_each(run, || next().map(|bits| low_u16(bits).to_le_bytes())),
        24 => write_each(run, || next().map(three)),
        _ => write_each(run, || next().map(u32::to_le_bytes)),
    }
}

/// The same for pixels of `N` bytes.
///
/// The inner loop ends at a pixel that `next` leaves out. An iterator that looks whether it has ended then looks only there, not at
/// every pixel.
#[inline(always)]
fn write_each<const N: usize>(run: &mut [u8], mut next: impl FnMut() -> Option<[u8; N]>)
where
    [u8; N]: Pod,
{
    let (_, pixels, _) = pod_align_to_mut::<u8, [u8; N]>(run);
    let mut places = pixels.iter_mut();
    while places.len() > 0 {
        for place in places.by_ref() {
            let Some(pixel) = next() else { break };
            *place = pixel;
        }
    }
}

/// Writes few pixels in each of some rows: see [`rows::write_rows`](crate::pixel::rows::write_rows). `false` where rows are not whole
/// pixels apart.
#[inline(always)]
pub(in crate::pixel::rows) fn write_rows<F: PixelFormat, R>(
    memory: &mut [u8],
    (stride, row, x): (usize, usize, usize),
    spans: &[[u8; 2]],
    start: impl FnMut(u8) -> R,
    mut next: impl FnMut(&mut R) -> u32,
) -> bool {
    let size = bytes_per_pixel::<F>();
    if !stride.is_multiple_of(size) {
        return false;
    }
    let (place, pitch) = ((row / size).wrapping_add(x), stride / size);
    match F::BITS {
        8 => few_in_rows(memory, (place, pitch), spans, start, |run| low_u8(next(run))),
        16 => {
            if HALVES {
                if let ([], halves, []) = pod_align_to_mut::<u8, u16>(memory) {
                    few_in_rows(halves, (place, pitch), spans, start, |run| low_u16(next(run)).to_le());
                    return true;
                }
            }
            let pixels = pod_align_to_mut::<u8, [u8; 2]>(memory).1;
            few_in_rows(pixels, (place, pitch), spans, start, |run| low_u16(next(run)).to_le_bytes());
        }
        24 => {
            let pixels = pod_align_to_mut::<u8, [u8; 3]>(memory).1;
            few_in_rows(pixels, (place, pitch), spans, start, |run| three(next(run)));
        }
        _ => {
            let pixels = pod_align_to_mut::<u8, [u8; 4]>(memory).1;
            few_in_rows(pixels, (place, pitch), spans, start, |run| next(run).to_le_bytes());
        }
    }
    true
}

/// The same in pixels, from a place on.
#[inline(always)]
fn few_in_rows<R, T>(
    pixels: &mut [T],
    (mut place, pitch): (usize, usize),
    spans: &[[u8; 2]],
    mut start: impl FnMut(u8) -> R,
    mut next: impl FnMut(&mut R) -> T,
) {
    for &[right, n] in spans {
        let (mut run, first) = (start(right), place.wrapping_add(right.into()));
        if let Some(pixels) = pixels.get_mut(first..first.wrapping_add(n.into())) {
            for pixel in pixels {
                // Where counters have no register, it is better unrolled.
                keep_rolled(FOURS && UNALIGNED);
                *pixel = next(&mut run);
            }
        }
        place = place.wrapping_add(pitch);
    }
}

/// Replaces each pixel of a run by what `edit` makes of it.
#[inline(always)]
pub(in crate::pixel::rows) fn edit<F: PixelFormat>(run: &mut [u8], mut edit: impl FnMut(u32) -> u32) {
    match F::BITS {
        8 => each(run, |[a]: &mut [u8; 1]| *a = low_u8(edit(u32::from(*a)))),
        16 => each(run, |place| *place = low_u16(edit(u16::from_le_bytes(*place).into())).to_le_bytes()),
        24 => each(run, |place: &mut [u8; 3]| {
            let [a, b, c] = *place;
            *place = three(edit(u32::from_le_bytes([a, b, c, 0])));
        }),
        _ => each(run, |place| *place = edit(u32::from_le_bytes(*place)).to_le_bytes()),
    }
}

/// Replaces each pixel of a run by what `mix` makes of it and of its level.
#[inline(always)]
pub(in crate::pixel::rows) fn mix<F: PixelFormat>(run: &mut [u8], levels: &[u8], mut mix: impl FnMut(u32, u8) -> u32) {
    #[inline(always)]
    fn with_levels<const N: usize>(run: &mut [u8], levels: &[u8], mut f: impl FnMut([u8; N], u8) -> [u8; N])
    where
        [u8; N]: Pod,
    {
        let (_, pixels, _) = pod_align_to_mut::<u8, [u8; N]>(run);
        for (pixel, &level) in pixels.iter_mut().zip(levels) {
            // Rims are short: a loop of four in a turn has more to prepare than it saves.
            keep_rolled(!VECTORS);
            *pixel = f(*pixel, level);
        }
    }
    match F::BITS {
        8 => with_levels(run, levels, |[old], level| [low_u8(mix(old.into(), level))]),
        16 => with_levels(run, levels, |old, level| low_u16(mix(u16::from_le_bytes(old).into(), level)).to_le_bytes()),
        24 => with_levels(run, levels, |[a, b, c], level| three(mix(u32::from_le_bytes([a, b, c, 0]), level))),
        _ => with_levels(run, levels, |old, level| mix(u32::from_le_bytes(old), level).to_le_bytes()),
    }
}

/// Calls `f` with each pixel of a run.
#[inline(always)]
fn each<const N: usize>(run: &mut [u8], mut f: impl FnMut(&mut [u8; N]))
where
    [u8; N]: Pod,
{
    let (_, pixels, _) = pod_align_to_mut::<u8, [u8; N]>(run);
    for pixel in pixels {
        f(pixel);
    }
}
