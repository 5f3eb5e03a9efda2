//! No call of the list `calls` writes or reads more pixels than its window and its arguments allow.

#![allow(clippy::cast_possible_truncation, reason = "random numbers, cut on purpose")]

use std::cell::Cell;

use calls::{call, name, Arguments, COUNT};
use embedded_raster::{surface::Rows, ClippedSpan, Frame, Index4, Readable, Rect, Surface};
use twins::{
    arguments::{Ground, Scratch},
    input::Input,
    rng::{cases, Rng},
};

/// A surface that counts what is asked for.
struct Counted<'a> {
    inner: Frame<&'a mut [u8], Rows<Index4>>,
    written: usize,
    read: Cell<usize>,
}

impl Surface for Counted<'_> {
    type Color = Index4;

    fn window(&self) -> Rect {
        self.inner.window()
    }

    fn fill_span(&mut self, span: ClippedSpan, color: Index4) {
        self.written += span.len() as usize;
        self.inner.fill_span(span, color);
    }
}

impl Readable for Counted<'_> {
    fn color_at(&self, x: i32, y: i32) -> Index4 {
        self.read.set(self.read.get() + 1);
        self.inner.color_at(x, y)
    }
}

/// How often a call may write and read a pixel, on a window of so many columns and rows. What is new in the list and not here
/// may paint each pixel of the window once, and read none.
fn bound(name: &str, (w, h): (usize, usize), a: &Arguments<'_, Rows<Index4>>, answer: usize) -> (usize, usize) {
    let (all, line) = (w * h, w.max(h));
    let pixels = |area: Rect| area.width() as usize * area.height() as usize;
    let (owner, function) = name.split_once("::").expect("a name has an owner");
    match (owner, function) {
        (_, "draw_line" | "draw_line_fx" | "shade_line_fx" | "fill_steps") | ("Line", "draw") => (line, 0),
        (_, "depth_line_fx") | ("Line", "draw_depth") => (line.min(16), 0),
        // Three points.
        ("Splat", "draw") => (3 * all, 0),
        ("Splat", "draw_depth") => (3 * all.min(16 * 16), 0),
        (_, "draw_triangle") => (3 * line, 0),
        (_, "draw_polyline" | "draw_polygon") => ((a.corners.len() + 1) * line, 0),
        // A cubic curve passes a column three times, and a row.
        (_, "draw_path_fx") => ((a.segments.len() + 1) * 3 * (w + h), 0),
        (_, "draw_quadratic_fx" | "draw_cubic_fx") => (3 * (w + h), 0),
        (_, "draw_ellipse" | "draw_arc" | "draw_rounded" | "draw_rectangle" | "fill_octants") => (2 * (w + h), 0),
        (_, "draw_point" | "draw_point_fx" | "set") => (1, 0),
        (_, "draw_iter") => (3, 0),
        (_, "blit" | "blit_keyed" | "copy_picture") => (all.min(pixels(a.picture.window())), 0),
        (_, "blit_mask") => (all.min(pixels(a.mask.window())), 0),
        (_, "copy_mask") => (all.min(pixels(a.mask_msb0.window())), 0),
        (_, "move_area" | "move_area_keyed" | "copy_area" | "blit_with" | "mix_row") => (all, all),
        (_, "fill_span" | "write_span" | "write_some") => (w, 0),
        (_, "edit_span" | "mix_span") => (w, w),
        (_, "read_span" | "find" | "find_start") => (0, w),
        (_, "color_at" | "get") => (0, 1),
        // What is connected is painted once. With too few slots, how often it is read is counted in `raster::flood`.
        (_, "flood_fill" | "flood_fill_to") if answer > a.slots.len() => (all, usize::MAX),
        (_, "flood_fill" | "flood_fill_to") => (all, 9 * (all + 1)),
        // A triangle, a box in outline, a line; and pixel by pixel, back again.
        (_, "draw_on") => (all + 2 * (w + h) + line, 0),
        // Drawn twice, by the depths that lie in 16 x 16 pixels.
        ("DepthShade", "read_only") => (2 * all.min(16 * 16), 0),
        ("DepthShade", _) | (_, "depth_triangle_fx" | "fill_depth" | "fill_behind") => (all.min(16 * 16), 0),
        (_, "bounding_box" | "fill_corridor") => (0, 0),
        _ => (all, 0),
    }
}

/// No call writes or reads more than the window and its arguments allow, whatever the arguments are.
#[test]
fn calls_write_and_read_what_the_window_shows() {
    let (mut rng, mut scratch) = (Rng::new(990), Scratch::new(990));
    let mut most = [0; COUNT];
    for _ in 0..cases(1_000) {
        let mut pixels: Vec<u8> = (0..21 * 29).map(|_| if rng.one_in(3) { rng.bits() as u8 } else { 0 }).collect();
        for (number, most) in most.iter_mut().enumerate() {
            let window = if rng.one_in(2) { Rect::new(0, 0, 41, 29) } else { Rect::new(3, 2, 30, 25) };
            let ground = if rng.one_in(2) { Ground::Wild } else { Ground::Near(window) };
            let colors = [Index4::new(rng.below(16) as u8), Index4::new(rng.below(16) as u8)];
            let bytes: Vec<u8> = (0..150).flat_map(|_| rng.bits().to_le_bytes()).collect();
            let mut arguments = scratch.arguments::<Rows<Index4>>(&mut Input(&bytes), ground, colors);
            let mut frame = Frame::<_, Rows<Index4>>::new(&mut pixels[..], 41, 29).expect("the right size");
            let mut counted = Counted { inner: frame.clipped(window), written: 0, read: Cell::new(0) };
            let answer = call(&mut counted, &mut arguments, number);
            let (written, read, name) = (counted.written, counted.read.get(), name(number));
            let (writes, reads) = bound(name, (window.width() as usize, window.height() as usize), &arguments, answer);
            assert!(written <= writes, "{name} wrote {written} pixels, at most {writes}: answer {answer}");
            assert!(read <= reads, "{name} read {read} pixels, at most {reads}: answer {answer}");
            *most = (*most).max(written + read);
        }
    }
    let idle: Vec<_> = (0..COUNT).filter(|&number| most[number] == 0).map(name).collect();
    assert_eq!(
        idle,
        [
            "RecoloredAt::bounding_box",
            "SurfaceTarget::bounding_box",
            "Recolored::bounding_box",
            "Readable::fill_corridor"
        ],
        "questions, and a shortcut that a surface need not have; no others"
    );
}
