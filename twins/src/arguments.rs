//! [`Scratch`]: arguments for every call of the list `calls`.

use calls::Arguments;
use embedded_graphics_core::geometry::Point;
use embedded_raster::{
    geom::triangulate::SideSlot,
    raster::{
        flood::FloodSlot,
        stroke::{Cap, Join},
    },
    Angle, EdgeSlot, Ellipse, Frame, Layout, PathSegment, PointFx, Radii, Rect, Sector, Stroke,
};
use fixed::types::I24F8;

use super::{input::Input, rng::Rng};

/// Where coordinates lie.
#[derive(Clone, Copy, Debug)]
pub enum Ground {
    /// In a window or a few pixels off, now and then anywhere.
    Near(Rect),
    /// Anywhere.
    Wild,
    /// Within some pixels of a place that may be anywhere. Shapes are small, so that the window may be all of the plane.
    Close(i32, i32),
}

/// The memory that arguments borrow.
pub struct Scratch {
    corners: Vec<Point>,
    contour: Vec<PointFx>,
    segments: Vec<PathSegment>,
    dashes: Vec<I24F8>,
    starts: Vec<u16>,
    table: Vec<EdgeSlot>,
    slots: Vec<FloodSlot>,
    sides: Vec<SideSlot>,
    triangles: Vec<[u16; 3]>,
    neighbours: Vec<[u16; 3]>,
    bytes: Vec<u8>,
    out: Vec<u8>,
}

/// Bytes of pictures and masks.
const BYTES: usize = 2_000;

impl Scratch {
    /// Its pictures are noise from a seed.
    pub fn new(seed: u64) -> Self {
        let mut rng = Rng::new(seed);
        // Half of them plain, so that there are runs of one colour.
        let bytes = (0..BYTES / 40).flat_map(|_| {
            let plain = rng.one_in(2).then(|| rng.bits() as u8);
            [(); 40].map(|()| plain.unwrap_or(rng.bits() as u8))
        });
        Self {
            bytes: bytes.collect(),
            out: vec![0; 100],
            corners: vec![],
            contour: vec![],
            segments: vec![],
            dashes: vec![],
            starts: vec![],
            table: vec![],
            slots: vec![],
            sides: vec![],
            triangles: vec![],
            neighbours: vec![],
        }
    }

    /// Arguments out of an input: the same ones from the same bytes. What shapes are clipped against is small, too, unless the
    /// shapes are.
    pub fn arguments<L: Layout>(
        &mut self,
        input: &mut Input<'_>,
        ground: Ground,
        colors: [L::Color; 2],
    ) -> Arguments<'_, L> {
        let mut on = On { input, ground };
        self.fill(&mut on);
        let window = match ground {
            Ground::Near(window) => window,
            Ground::Wild => on.input.small_window(),
            Ground::Close(..) => Rect::new(i32::MIN, i32::MIN, i32::MAX, i32::MAX),
        };
        let picture = part_of_a_picture::<L>(&self.bytes, &mut on);
        Arguments {
            points: [(); 3].map(|()| on.point()),
            places: [(); 4].map(|()| on.place()),
            areas: [(); 2].map(|()| on.area()),
            ellipses: [(); 2].map(|()| on.ellipse()),
            size: on.length(),
            radii: Radii {
                top_left: on.radius(),
                top_right: on.radius(),
                bottom_right: on.radius(),
                bottom_left: on.radius(),
            },
            sector: Sector::new(on.angle(), on.angle()),
            corners: &self.corners,
            contour: &self.contour,
            segments: &self.segments,
            stroke: Stroke::new(on.length())
                .with_cap(on.input.pick(&[Cap::Butt, Cap::Round, Cap::Square]))
                .with_join(on.input.pick(&[Join::Miter, Join::Round, Join::Bevel]))
                .with_miter_limit(on.length()),
            dashes: &self.dashes,
            phase: I24F8::from_bits(on.input.wild()),
            flag: on.input.one_in(2),
            table: &mut self.table,
            slots: &mut self.slots,
            colors,
            picture,
            mask: part_of_a_picture(&self.bytes, &mut on),
            mask_msb0: part_of_a_picture(&self.bytes, &mut on),
            window,
            numbers: [(); 6].map(|()| on.input.wild()),
            bytes: &self.bytes[on.input.index(BYTES / 2)..][..on.input.index(300)],
            out: &mut self.out,
            starts: &self.starts,
            sides: &mut self.sides,
            triangles: &mut self.triangles,
            neighbours: &mut self.neighbours,
        }
    }

    fn fill(&mut self, on: &mut On<'_, '_>) {
        self.corners.clear();
        self.corners.extend((0..on.input.index(6)).map(|_| on.point()));
        self.contour.clear();
        if on.input.one_in(4) && !matches!(on.ground, Ground::Close(..)) {
            // On a coarse grid places meet.
            let place = |_| PointFx::px(on.input.within(0, 3), on.input.within(0, 3));
            self.contour.extend((0..12).map(place));
        }
        self.contour.truncate(on.input.index(13));
        self.contour.extend((0..on.input.index(7)).map(|_| on.place()));
        self.segments.clear();
        let n = on.segments();
        // A path without this begins at the origin, which may be far.
        self.segments.extend((n > 0).then(|| PathSegment::MoveTo(on.place())));
        self.segments.extend((0..n).map(|_| on.segment()));
        self.dashes.clear();
        self.dashes.extend((0..on.input.index(4)).map(|_| on.dash()));
        self.starts.clear();
        let n = on.input.index(4);
        let start = |_| if on.input.one_in(9) { on.input.wild() as u16 } else { on.input.below(13) as u16 };
        self.starts.extend((0..n).map(start));
        self.table.clear();
        self.table.extend((0..on.input.index(64)).map(|_| EdgeSlot::EMPTY));
        self.slots.clear();
        self.slots.resize(on.input.index(9), FloodSlot::EMPTY);
        self.sides.clear();
        self.sides.resize(on.input.index(60), SideSlot::EMPTY);
        self.triangles.clear();
        self.triangles.extend((0..on.input.index(30)).map(|_| [(); 3].map(|()| on.input.below(14) as u16)));
        self.neighbours.clear();
        self.neighbours.resize(on.input.index(50), [0; 3]);
        self.out.resize(on.input.index(100), 0);
    }
}

/// A picture, or a view or a part of it.
fn part_of_a_picture<'a, L: Layout>(bytes: &'a [u8], on: &mut On<'_, '_>) -> Frame<&'a [u8], L> {
    let (start, gap) = (on.input.index(200), on.input.pick(&[0, 0, 1, 2, 3]));
    let (width, mut height) = (on.input.below(81) as u16, on.input.below(17) as u16);
    let picture = loop {
        match Frame::<_, L>::with_stride(&bytes[start..], width, height, L::row_bytes(width) + gap) {
            Ok(picture) => break picture,
            Err(_) => height /= 2,
        }
    };
    let mut side = || i32::from(on.input.byte() as i8) / 4;
    let area = Rect::new(side(), side() / 4, side() + 30, side() / 4 + 8);
    let area = if on.input.one_in(16) { on.input.wild_area() } else { area };
    match on.input.below(4) {
        0 => picture.view(area),
        1 => picture.clipped(area),
        _ => picture,
    }
}

impl Input<'_> {
    /// A window of at most 16 x 16, anywhere, sometimes inside out.
    pub fn small_window(&mut self) -> Rect {
        let (x, y) = (self.wild(), self.wild());
        Rect::new(x, y, x.saturating_add(self.within(-1, 16)), y.saturating_add(self.within(-1, 16)))
    }

    /// Four wild numbers.
    pub fn wild_area(&mut self) -> Rect {
        Rect::new(self.wild(), self.wild(), self.wild(), self.wild())
    }
}

/// An input on a ground.
struct On<'a, 'b> {
    input: &'a mut Input<'b>,
    ground: Ground,
}

impl On<'_, '_> {
    /// A number of pixels.
    fn pixel(&mut self, side: impl Fn(Rect) -> (i32, i32), around: impl Fn(i32, i32) -> i32) -> i32 {
        match self.ground {
            Ground::Near(window) if !self.input.one_in(24) => {
                let (low, high) = side(window);
                // The first and the last one more often than others.
                match self.input.below(16) {
                    0 => return low,
                    1 => return high.saturating_sub(1),
                    _ => {}
                }
                self.input.within(low.saturating_sub(6), high.saturating_add(6).min(low.saturating_add(9_000)).max(low))
            }
            Ground::Close(x, y) => around(x, y).saturating_add(self.input.within(-300, 300)),
            _ => self.input.wild(),
        }
    }

    fn point(&mut self) -> Point {
        Point::new(
            self.pixel(|window| (window.x0, window.x1), |x, _| x),
            self.pixel(|window| (window.y0, window.y1), |_, y| y),
        )
    }

    /// A number of units around a pixel.
    fn units(&mut self, pixel: i32, around: impl Fn(i32, i32) -> i32) -> i32 {
        match self.ground {
            Ground::Near(_) => {
                let fraction = if self.input.one_in(3) { 128 } else { self.input.byte().into() };
                pixel.saturating_mul(256).saturating_add(fraction)
            }
            Ground::Wild => pixel,
            Ground::Close(x, y) => around(x, y).saturating_add(self.input.within(-2_000, 2_000)),
        }
    }

    fn place(&mut self) -> PointFx {
        let Point { x, y } = self.point();
        PointFx::from_bits(self.units(x, |x, _| x), self.units(y, |_, y| y))
    }

    fn area(&mut self) -> Rect {
        let Point { x, y } = self.point();
        let (width, height) = match self.ground {
            Ground::Wild if self.input.one_in(2) => return Rect::new(x, y, self.input.wild(), self.input.wild()),
            Ground::Close(..) => (self.input.within(-1, 300), self.input.within(-1, 300)),
            _ => (self.input.within(-1, 40), self.input.within(-1, 40)),
        };
        // Many of them square, so that there are circles.
        let height = if self.input.one_in(2) { width } else { height };
        Rect::new(x, y, x.saturating_add(width), y.saturating_add(height))
    }

    /// A radius or a width in units.
    fn length(&mut self) -> I24F8 {
        I24F8::from_bits(match self.ground {
            Ground::Wild => self.input.wild(),
            _ => self.input.within(-20, 4_000),
        })
    }

    fn ellipse(&mut self) -> Ellipse {
        match self.input.below(4) {
            0 => Ellipse::in_box(self.area()),
            1 => Ellipse::circle(self.place(), self.length()),
            2 => Ellipse::splat(self.place(), self.length()),
            _ => Ellipse::new(self.place(), self.length(), self.length()),
        }
    }

    fn radius(&mut self) -> u32 {
        match self.ground {
            Ground::Wild => self.input.wild() as u32,
            _ => self.input.below(20),
        }
    }

    fn angle(&mut self) -> Angle {
        match self.input.below(3) {
            0 => Angle::degrees(self.input.wild()),
            1 => Angle::turns(self.input.wild() as u32, self.input.wild() as u16),
            _ => Angle::from_bits(self.input.wild() as u32).plus(self.input.wild()),
        }
    }

    /// How many there are. Work on wild paths depends on how long they are: not often.
    fn segments(&mut self) -> usize {
        match self.ground {
            Ground::Wild if !self.input.one_in(20) => 0,
            _ => self.input.index(5),
        }
    }

    fn segment(&mut self) -> PathSegment {
        match self.input.below(6) {
            0 => PathSegment::MoveTo(self.place()),
            1 | 2 => PathSegment::LineTo(self.place()),
            3 => PathSegment::QuadraticTo(self.place(), self.place()),
            4 => PathSegment::CubicTo(self.place(), self.place(), self.place()),
            _ => PathSegment::Close,
        }
    }

    fn dash(&mut self) -> I24F8 {
        I24F8::from_bits(match self.ground {
            Ground::Wild => self.input.wild(),
            _ => self.input.within(50, 2_000),
        })
    }
}
