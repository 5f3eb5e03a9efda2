//! An engine: what it can draw, as a set of functions over its frame `F`.

use crate::scene::{
    Blob, Curve, Flooded, Format, Indexed, Ink, Label, Outline, Rect, Segment, Sprite, Track, Triangle, Work,
};

/// Functions that draw workloads into a frame `F`. What is `None` is left out of the table.
///
/// A function gets all items of its workload at once, so that the loop over them is compiled
/// together with the drawing, as it would be in a firmware.
pub struct Engine<F> {
    /// As it appears in the table.
    pub name: &'static str,
    /// How the frame stores its pixels.
    pub format: Format,
    /// Makes every byte 0: before each workload.
    pub blacken: fn(&mut F),
    /// The bytes of the frame, for its checksum: after each workload.
    pub bytes: fn(&F) -> &[u8],
    /// The whole frame.
    pub clear: Option<fn(&mut F, Ink)>,
    /// Filled rectangles.
    pub rects: Option<fn(&mut F, &[Rect])>,
    /// Rectangles one pixel high.
    pub rows: Option<fn(&mut F, &[Rect])>,
    /// Rectangles one pixel wide.
    pub columns: Option<fn(&mut F, &[Rect])>,
    /// Lines, both ends drawn.
    pub lines: Option<fn(&mut F, &[Segment])>,
    /// Filled triangles.
    pub triangles: Option<fn(&mut F, &[Triangle])>,
    /// Filled circles.
    pub discs: Option<fn(&mut F, &[Rect])>,
    /// Outlines of circles.
    pub circles: Option<fn(&mut F, &[Rect])>,
    /// Rounded rectangles.
    pub rounded: Option<fn(&mut F, &[Rect])>,
    /// A region, flooded twice. It is drawn when its seed is black.
    pub flood: Option<fn(&mut F, &Flooded<'_>)>,
    /// A filled simple polygon.
    pub polygon: Option<fn(&mut F, &Outline<'_>)>,
    /// Cubic curves, one pixel wide.
    pub curves: Option<fn(&mut F, &[Curve])>,
    /// What cubic curves enclose.
    pub blob: Option<fn(&mut F, &Blob<'_>)>,
    /// Lines [`THICK`](crate::scene::THICK) pixels wide, without caps.
    pub thick: Option<fn(&mut F, &[Segment])>,
    /// Lines with a width and round corners, with gaps or without.
    pub track: Option<fn(&mut F, &Track<'_>)>,
    /// A picture at several places.
    pub blit: Option<fn(&mut F, &Sprite<'_>)>,
    /// The same, leaving out the pixels whose value is 0.
    pub blit_key: Option<fn(&mut F, &Sprite<'_>)>,
    /// 8-bit indices through a table of RGB565 colours.
    pub expand: Option<fn(&mut F, &Indexed<'_>)>,
    /// 4-bit indices through a table, as RGB565 with the high byte first.
    pub expand_pairs: Option<fn(&mut F, &Indexed<'_>)>,
    /// The same, row by row.
    pub expand_rows: Option<fn(&mut F, &Indexed<'_>)>,
    /// Text of embedded-graphics.
    pub text: Option<fn(&mut F, &[Label<'_>])>,
}

impl<F> Engine<F> {
    /// An engine that can draw nothing yet.
    pub const fn new(name: &'static str, format: Format, blacken: fn(&mut F), bytes: fn(&F) -> &[u8]) -> Self {
        Self {
            name,
            format,
            blacken,
            bytes,
            clear: None,
            rects: None,
            rows: None,
            columns: None,
            lines: None,
            triangles: None,
            discs: None,
            circles: None,
            rounded: None,
            flood: None,
            polygon: None,
            curves: None,
            blob: None,
            thick: None,
            track: None,
            blit: None,
            blit_key: None,
            expand: None,
            expand_pairs: None,
            expand_rows: None,
            text: None,
        }
    }

    /// Draws a workload, or returns `None` when this engine cannot.
    pub fn draw(&self, frame: &mut F, work: &Work<'_>) -> Option<()> {
        match work {
            Work::Clear(ink) => self.clear?(frame, *ink),
            Work::Rects(rects) => self.rects?(frame, rects),
            Work::Rows(rows) => self.rows?(frame, rows),
            Work::Columns(columns) => self.columns?(frame, columns),
            Work::Lines(lines) => self.lines?(frame, lines),
            Work::Triangles(triangles) => self.triangles?(frame, triangles),
            Work::Discs(discs) => self.discs?(frame, discs),
            Work::Circles(circles) => self.circles?(frame, circles),
            Work::Rounded(rounded) => self.rounded?(frame, rounded),
            Work::Flood(flooded) => self.flood?(frame, flooded),
            Work::Polygon(outline) => self.polygon?(frame, outline),
            Work::Curves(curves) => self.curves?(frame, curves),
            Work::Blob(blob) => self.blob?(frame, blob),
            Work::Thick(lines) => self.thick?(frame, lines),
            Work::Track(track) => self.track?(frame, track),
            Work::Blit(sprite) => self.blit?(frame, sprite),
            Work::BlitKey(sprite) => self.blit_key?(frame, sprite),
            Work::Expand(indexed) => self.expand?(frame, indexed),
            Work::ExpandPairs(indexed) => self.expand_pairs?(frame, indexed),
            Work::ExpandRows(indexed) => self.expand_rows?(frame, indexed),
            Work::Text(labels) => self.text?(frame, labels),
        }
        Some(())
    }
}
