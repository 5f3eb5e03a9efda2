//! The list of what needs no surface: shapes to spans, geometry, angles, palettes.

use embedded_graphics_core::{
    geometry::Size,
    pixelcolor::{Rgb565, Rgb888, RgbColor},
    primitives::Rectangle,
};
use embedded_raster::{
    buffer_bytes,
    geom::{self, clip, delaunay, exact, polygon as outlines, triangulate, Contours, Outlines},
    paint::{pattern, Ramp, RasterOp},
    pixel::{self, Atkinson, Be, ColorCube, FloydSteinberg, Lsb0},
    raster::{
        arc, coverage, ellipse,
        flood::{self, FloodTarget},
        line, line_fx,
        mapped::{self, Texels},
        outline, polygon, rectangle, rounded, stroke, triangle,
    },
    surface::{paged_bytes, Counter, Sheet},
    Affine, Angle, Canvas, ClippedSpan, CoverageSlot, Ellipse, Framebuffer, Index1, Index2, Index4, Index8, Layout,
    Octants, Palette, Path, PointFx, Radii, Rect, Sector, Sink, SoftRow, Steps, Stroke, Surface, Viewport,
};
use fixed::types::I16F16;

use crate::{
    answer::{sum, Answer},
    antialias::{self, with_scratch},
    calls, Arguments,
};

calls! {
    /// Makes the call of a number below that of [`NAMES`]. Shapes are clipped against the window of the arguments.
    NAMES, call[L: Layout](on: &mut Palette<Rgb888, 16>, a)
    {
        let (window, rule, [n, m, ..]) = (a.window, a.rule(), a.numbers);
        let ([p, q, r, s], [area, other]) = (a.places, a.areas);
        let (angle, second) = (Angle::from_bits(n.unsigned_abs()), Angle::from_bits(m.cast_unsigned()));
        let (path, ellipse) = (Path::new(a.segments), a.ellipses[0]);
    }
    [line]
    draw => spans(|look| line::draw(a.points[0], a.points[1], window, look));
    extent => line::extent(a.points[0], a.points[1]);
    clip => a.steps().map(|steps| if steps.len() < 100 { spans(|look| steps.spans(look)) } else { 0 });
    [line_fx]
    draw => spans(|look| line_fx::draw(p, q, window, look));
    extent => line_fx::extent(p, q);
    clip => line_fx::clip(p, q, window).map(|steps| (steps.first(), steps.last()));
    [outline]
    draw => spans(|look| outline::draw(path, window, look));
    extent => outline::extent(path);
    // Of ellipses; the file has the name of the one above.
    outline => spans(|look| ellipse::outline(area, window, look));
    enclosed => spans(|look| ellipse::enclosed(area, window, look));
    [ellipse]
    fill => spans(|look| ellipse::fill(ellipse, window, look));
    square => ellipse::square(p, a.size);
    [rounded]
    fill => spans(|look| rounded::fill(area, a.radii, window, look));
    outline => spans(|look| rounded::outline(area, a.radii, window, look));
    enclosed => spans(|look| rounded::enclosed(area, a.radii, window, look));
    border => spans(|look| rounded::border(area, a.radii, n.unsigned_abs() % 64, a.align(), window, look));
    [arc]
    outline => spans(|look| arc::outline(area, a.sector, window, look));
    fill => spans(|look| arc::fill(ellipse, a.sector, window, look));
    ring => spans(|look| arc::ring(ellipse, a.ellipses[1], window, look));
    ring_sector => spans(|look| arc::ring_sector(ellipse, a.ellipses[1], a.sector, window, look));
    [polygon]
    fill => {
        let mut sum = 0_usize;
        let (first, second) = a.contour.split_at_checked(a.length(5) % 8).unwrap_or((a.contour, &[]));
        let filled = polygon::fill([first, second], rule, a.table, window, add(&mut sum));
        filled.map(|()| sum)
    };
    extent => polygon::extent([a.contour]);
    is_convex => outlines::is_convex(a.contour);
    twice_area => outlines::twice_area(a.contour);
    orientation => outlines::orientation(a.contour);
    contains => outlines::contains([a.contour], rule, p);
    crossings => outlines::crossings::<_, 4>([a.contour], p.y).map(|crossings| crossings.len());
    [stroke]
    fill => {
        let mut sum = 0_usize;
        stroke::fill(path, &a.stroke.dashed(a.dashes, a.phase), a.table, window, add(&mut sum)).map(|()| sum)
    };
    fill_polyline => {
        let mut sum = 0_usize;
        stroke::fill_polyline(a.contour, a.flag, &a.stroke, a.table, window, add(&mut sum)).map(|()| sum)
    };
    border => {
        let mut sum = 0;
        stroke::border(path, &a.stroke.dashed(a.dashes, a.phase), window, |a, b| sum = (sum, (a, b)).answer());
        sum
    };
    border_of_polyline => {
        let mut sum = 0;
        stroke::border_of_polyline(a.contour, a.flag, &a.stroke, window, |a, b| sum = (sum, (a, b)).answer());
        sum
    };
    extent => stroke::extent(path, &a.stroke);
    // Coverage, in the files that its functions are in.
    [fill]
    cells => coverage::cells(a.halves(0)[0]);
    extent => coverage::extent([a.contour]);
    fill => covered(|table, cells, look| {
        let (first, second) = a.contour.split_at_checked(a.length(5) % 8).unwrap_or((a.contour, &[]));
        coverage::fill([first, second], rule, table, cells, window, look).is_ok()
    });
    fill_true => covered(|table, cells, look| {
        let (first, second) = a.contour.split_at_checked(a.length(5) % 8).unwrap_or((a.contour, &[]));
        coverage::fill_true([first, second], rule, table, cells, window, look).is_ok()
    });
    [line]
    line => covered(|_, _, look| { coverage::line(p, q, window, look); true });
    [oval]
    ellipse => covered(|_, _, look| { coverage::ellipse(ellipse, window, look); true });
    ring => covered(|_, _, look| { coverage::ring(ellipse, a.ellipses[1], window, look); true });
    [shapes]
    path => covered(|table, cells, look| coverage::path(path, rule, table, cells, window, look).is_ok());
    path_true => covered(|table, cells, look| coverage::path_true(path, rule, table, cells, window, look).is_ok());
    stroke_true => covered(|table, cells, look| {
        coverage::stroke_true(path, &a.stroke.dashed(a.dashes, a.phase), table, cells, window, look).is_ok()
    });
    stroke => covered(|table, cells, look| {
        coverage::stroke(path, &a.stroke.dashed(a.dashes, a.phase), table, cells, window, look).is_ok()
    });
    stroke_polyline => covered(|table, cells, look| {
        coverage::stroke_polyline(a.contour, a.flag, &a.stroke, (table, cells), window, look).is_ok()
    });
    rounded => covered(|table, cells, look| coverage::rounded(area, a.radii, table, cells, window, look).is_ok());
    triangle => covered(|_, cells, look| { coverage::triangle(a.corners_fx(), cells, window, look); true });
    rectangle => covered(|_, _, look| { coverage::rectangle(p, q, window, look); true });
    [round]
    sector => part_covered(|table, cells, look| coverage::sector(ellipse, a.sector, table, cells, window, look).is_ok());
    ring_sector => part_covered(|table, cells, look| {
        coverage::ring_sector(ellipse, a.ellipses[1], a.sector, (table, cells), window, look).is_ok()
    });
    [Ramp]
    of_palette => antialias::mixed(a);
    color => Ramp::<_, 7>::new([n, m, 3, 4, 5, 6, 7]).color(a.byte(0));
    [CoverIndex]
    new => antialias::mixed(a);
    [mapped]
    fill => {
        let (mut sum, size) = (0, Size::new(a.tile().into(), a.tile().into()));
        let look = |span, texels| sum = (sum, texel(span, texels)).answer();
        mapped::fill(&a.map(), size, window, look).map(|()| sum)
    };
    stretch => {
        let mut sum = 0;
        mapped::stretch(area, a.extent(), window, |span, texels| sum = (sum, texel(span, texels)).answer());
        sum
    };
    [Texels]
    texel => {
        let mut sum = 0;
        mapped::stretch(other, a.extent(), window, |span, texels| sum = (sum, texel(span, texels)).answer());
        sum
    };
    [ColorCube]
    new => ColorCube::<64>::new(on).nearest(Rgb888::RED);
    nearest => ColorCube::<512>::new(on).nearest(Rgb888::new(a.byte(1), a.byte(2), a.byte(3)));
    [FloydSteinberg]
    new => {
        let mut row = [[i16::from(a.byte(0)); 3]; 5];
        diffuse(a, FloydSteinberg::new(&mut row), |diffusion, level, nearest| diffusion.next(level, nearest))
    };
    next => diffuse(a, FloydSteinberg::new(&mut []), |diffusion, level, nearest| diffusion.next(level, nearest));
    [Atkinson]
    new => {
        let mut row = [[[i16::from(a.byte(0)); 3]; 2]; 5];
        diffuse(a, Atkinson::new(&mut row), |diffusion, level, nearest| diffusion.next(level, nearest))
    };
    next => diffuse(a, Atkinson::new(&mut []), |diffusion, level, nearest| diffusion.next(level, nearest));
    [Sheet]
    new => Sheet::new(&a.picture, a.tile(), a.halves(0)[0]).len();
    len => Sheet::new(&a.picture, a.tile(), a.tile()).len();
    is_empty => Sheet::new(&a.picture, a.tile(), a.tile()).is_empty();
    tile_size => Sheet::new(&a.picture, a.tile(), a.tile()).tile_size().width;
    tile => Sheet::new(&a.picture, a.tile(), a.tile()).tile(a.length(0)).map(|tile| tile.size().height);
    [pattern]
    shade => pattern::shade(n.unsigned_abs()).map(i32::from)[7];
    [RasterOp]
    and => operated(a, RasterOp::and, RasterOp::and);
    or => operated(a, RasterOp::or, RasterOp::or);
    xor => operated(a, RasterOp::xor, RasterOp::xor);
    invert => operated(a, |_| RasterOp::invert(), |_| RasterOp::invert());
    of => RasterOp::xor(Index4::new(a.byte(0))).of(Index4::new(a.byte(1))).index();
    [triangle]
    fill => spans(|look| triangle::fill(a.corners_fx(), window, look));
    extent => triangle::extent(a.corners_fx());
    [walk]
    walk => spans(|look| triangle::walk(a.corners_fx(), window, look));
    walk_blocks => spans(|look| triangle::walk_blocks(a.corners_fx(), window, look));
    [rectangle]
    pixels => rectangle::pixels(p, q);
    fill => spans(|look| rectangle::fill(area, window, look));
    outline => spans(|look| rectangle::outline(area, window, look));
    [flood]
    fill => flood::fill(&mut Flooded { window, bits: n.unsigned_abs() }, a.points[0], a.connectivity(), a.slots);
    [triangulate]
    each => {
        let mut sum = 0;
        triangulate::each(a.contour, a.starts, a.sides, |corners| sum = (sum, corners).answer()).map(|()| sum)
    };
    list => triangulate::list(a.contour, a.starts, a.sides, a.triangles);
    to_vec => triangulate::to_vec::<9>(a.contour, a.starts, a.sides).map(|triangles| triangles.len());
    [delaunay]
    refine => {
        // Of a triangulation, or of what is none.
        let count = if a.flag { triangulate::list(a.contour, a.starts, a.sides, a.triangles).ok() } else { None };
        let count = count.unwrap_or(a.triangles.len());
        a.triangles.get_mut(..count).map(|triangles| delaunay::refine(a.contour, triangles, a.neighbours))
    };
    [clip]
    segment => clip::segment(p, q, [r, s]).map(|clipped| (clipped.ends, clipped.at.map(|at| at.number)));
    [exact]
    turn => exact::turn(p, q, r);
    in_circle => exact::in_circle(p, q, r, s);
    [format]
    row_bytes => pixel::row_bytes::<Lsb0<Index2>>(a.halves(0)[0]);
    buffer_bytes => buffer_bytes::<Index4>(a.halves(0)[0], a.halves(0)[1]);
    [pages]
    paged_bytes => paged_bytes(a.halves(0)[0], a.halves(0)[1]);
    [Rect]
    new => Rect::new(n, m, n, m);
    with_size => Rect::with_size(a.points[0], a.extent());
    from_center => Rect::from_center(a.points[0], a.extent());
    is_empty => area.is_empty();
    contains => area.contains(n, m);
    intersection => area.intersection(other);
    union => area.union(other);
    translate => area.translate(n, m);
    relative_to => area.relative_to(n, m);
    inset => area.inset(n);
    top_left => area.top_left();
    size => area.size();
    width => area.width();
    height => area.height();
    from => Rect::from(Rectangle::new(a.points[0], a.extent()));
    [Rectangle]
    from => Rectangle::from(area);
    [Span]
    clip => a.span().clip(other);
    [SoftRow]
    span => soft_rows(a.corners_fx(), window, |row| (1, row.span()));
    left => soft_rows(a.corners_fx(), window, |row| sum(row.left().iter().copied()));
    right => soft_rows(a.corners_fx(), window, |row| sum(row.right().iter().copied()));
    each => soft_rows(a.corners_fx(), window, |row| {
        let mut sum = 0;
        row.each(|span, levels| sum = (sum, (span, levels.is_some())).answer());
        sum
    });
    [ClippedSpan]
    y => a.span().clip(other).map(ClippedSpan::y);
    x0 => a.span().clip(other).map(ClippedSpan::x0);
    x1 => a.span().clip(other).map(ClippedSpan::x1);
    len => a.span().clip(other).map(ClippedSpan::len);
    [Steps]
    first => a.steps().map(|steps| steps.first());
    last => a.steps().map(|steps| steps.last());
    len => a.steps().map(|steps| steps.len());
    is_steep => a.steps().map(|steps| steps.is_steep());
    goes_right => a.steps().map(|steps| steps.goes_right());
    next_is_minor => a.steps().map(|mut steps| steps.next_is_minor());
    spans => a.steps().filter(|steps| steps.len() < 100).map(|steps| spans(|look| steps.spans(look)));
    [Octants]
    first => crate::octants(area, window).map(|octants: Octants| octants.first());
    extent => crate::octants(area, window).map(|octants| octants.extent());
    [PointFx]
    new => PointFx::new(p.x, q.y);
    px => PointFx::px(n, m);
    from_bits => PointFx::from_bits(n, m);
    centre_of => PointFx::centre_of(a.points[0]);
    pixel => p.pixel();
    from => PointFx::from(a.points[0]);
    from => PointFx::from((n, m));
    add => p + q;
    sub => p - q;
    neg => -p;
    mul => p * q.x;
    add_assign => {
        let mut sum = p;
        sum += q;
        sum
    };
    sub_assign => {
        let mut sum = p;
        sum -= q;
        sum
    };
    [point]
    px => geom::px(n);
    [Angle]
    from_bits => Angle::from_bits(n.cast_unsigned());
    to_bits => angle.to_bits();
    turns => Angle::turns(n.cast_unsigned(), a.halves(1)[0]);
    degrees => Angle::degrees(n);
    degrees_fx => Angle::degrees_fx(I16F16::from_bits(n));
    to_degrees => second.to_degrees();
    cos_sin => second.cos_sin();
    clockwise_to => angle.clockwise_to(second);
    plus => second.plus(n);
    to_signed => second.to_signed();
    add => angle + second;
    sub => angle - second;
    neg => -second;
    mul => second * n;
    add_assign => {
        let mut sum = angle;
        sum += second;
        sum
    };
    sub_assign => {
        let mut sum = angle;
        sum -= second;
        sum
    };
    [Sector]
    new => Sector::new(angle, second).contains(n.into(), m.into());
    sweep => Sector::sweep(angle, I16F16::from_bits(m)).contains(n.into(), m.into());
    slice => Sector::slice(n.cast_unsigned(), m.cast_unsigned(), a.halves(2)[0]).contains(m.into(), n.into());
    contains => a.sector.contains(n.into(), m.into());
    [Ellipse]
    in_box => Ellipse::in_box(area);
    new => Ellipse::new(p, q.x, q.y);
    circle => Ellipse::circle(p, a.size);
    splat => Ellipse::splat(p, a.size);
    extent => ellipse.extent();
    [Radii]
    all => Radii::all(n.unsigned_abs()).top_left;
    from => Radii::from(n.unsigned_abs()).bottom_right;
    [Path]
    new => Path::new(a.segments).segments().len();
    segments => path.segments().len();
    contours => sum(path.contours().take(3).map(|contour| sum(contour.take(50))));
    contours_in => sum(path.contours_in(window).map(sum));
    fine_contours_in => sum(path.fine_contours_in(window).map(sum));
    outlines => path.outlines::<50, 2>().map(|outlines| outlines.vertices.len());
    [Contours]
    next => { let mut contours: Contours<_> = path.contours(); contours.next().map(|contour| contour.is_closed()) };
    [Contour]
    next => path.contours_in(window).next().and_then(|mut contour| contour.next());
    is_closed => path.contours_in(window).next().map(|contour| contour.is_closed());
    [Outlines]
    contours => path.outlines().map(|outlines: Outlines<50, 2>| sum(outlines.contours().map(<[PointFx]>::len)));
    [Stroke]
    new => stroke::extent(path, &Stroke::new(a.size));
    px => stroke::extent(path, &Stroke::px(a.halves(0)[0]));
    with_cap => stroke::extent(path, &a.stroke.with_cap(stroke::Cap::Square));
    with_join => stroke::extent(path, &a.stroke.with_join(stroke::Join::Miter));
    with_miter_limit => stroke::extent(path, &a.stroke.with_miter_limit(a.phase));
    dashed => stroke::extent(path, &a.stroke.dashed(a.dashes, a.phase));
    with_min_width => stroke::extent(path, &a.stroke.with_min_width(a.size));
    [Viewport]
    new => Viewport::new([p, q].map(|p| I16F16::from_bits(p.x.to_bits())), [r, s].map(|p| I16F16::from_bits(p.y.to_bits())), area).to_plane(p);
    from_bits => a.viewport().to_plane(p);
    with_y_up => a.viewport().with_y_up().to_plane(p);
    to_screen => a.viewport().to_screen(I16F16::from_bits(n), I16F16::from_bits(m));
    bits_to_screen => a.viewport().bits_to_screen([n, m]);
    to_plane => a.viewport().with_y_up().to_plane(q);
    to_plane_bits => a.viewport().to_plane_bits(p);
    [Counter]
    new => {
        let mut counter = Counter::<Rgb565>::new(window);
        counter.fill_area(area, Rgb565::RED);
        (counter.pixels & 0xffff_ffff, counter.spans & 0xffff_ffff)
    };
    [Palette]
    new => Palette::new([Rgb888::RED; 2]).colors().len();
    colors => on.colors().len();
    get => on.get(a.byte(0)).map(|color| color.r());
    set => on.set(a.byte(0), Rgb888::new(a.byte(1), a.byte(2), a.byte(3)));
    rotate => on.rotate(a.length(0)..a.length(1), a.length(2));
    map => {
        // Into every number of bits, out of every number of bits.
        on.expand::<Index1, Rgb888>(a.bytes, a.out);
        on.expand::<Lsb0<Index2>, Be<Rgb888>>(a.bytes, a.out);
        on.map(Rgb565::from).expand::<Index8, Rgb565>(a.bytes, a.out);
        on.map(pixel::Rgb332::from).expand::<Index8, pixel::Rgb332>(a.bytes, a.out);
        on.map(pixel::Xrgb8888::from).expand::<Index4, pixel::Xrgb8888>(a.bytes, a.out);
        on.map(Index2::from).expand::<Index8, Index2>(a.bytes, a.out);
        on.map(Index2::from).expand::<Index2, Lsb0<Index2>>(a.bytes, a.out);
    };
    expand => on.expand::<Index4, Rgb888>(a.bytes, a.out);
    between => on.between(&pixel::EGA, a.byte(0)).get(a.byte(1)).map(|color| color.b());
    nearest => on.nearest(Rgb888::new(a.byte(1), a.byte(2), a.byte(3)));
    greys => Palette::<_, 16>::greys().get(a.byte(0)).map(|color| color.g());
    rgb332 => Palette::rgb332().get(a.byte(0)).map(|color| color.b());
    web_safe => Palette::web_safe().get(a.byte(0)).map(|color| color.r());
}

/// Diffuses bytes over pixels whose channels are shown as whatever comes next.
fn diffuse<L: Layout, D>(
    a: &Arguments<'_, L>,
    mut diffusion: D,
    mut next: impl FnMut(&mut D, [u8; 3], &dyn Fn([u8; 3]) -> (u8, [u8; 3])) -> u8,
) -> usize {
    let mut last = 0_u8;
    let mut sum = 0_usize;
    for &byte in a.bytes.iter().take(40) {
        last = next(&mut diffusion, [byte, last, !byte], &|[r, g, b]| (r ^ g ^ b, [byte & 0xf0, 255, b]));
        sum = sum.wrapping_mul(3).wrapping_add(last.into());
    }
    sum
}

/// The first texel of a run, and its pixel.
fn texel(span: ClippedSpan, mut texels: Texels) -> (i32, i32) {
    let (column, row) = texels.texel();
    (span.x0() ^ column, span.y() ^ row)
}

/// Fills a triangle by an operation on indices, and by one on colours.
fn operated<L: Layout>(
    a: &mut Arguments<'_, L>,
    of_indices: impl Fn(Index4) -> RasterOp<Index4>,
    of_colors: impl Fn(Rgb565) -> RasterOp<Rgb565>,
) -> bool {
    let (corners, byte) = (a.corners_fx(), a.byte(0));
    if let Ok(mut frame) = Framebuffer::<Index4>::new(a.out, 4, 4) {
        frame.paint(of_indices(Index4::new(byte)), |window, brush| triangle::fill(corners, window, brush));
    }
    if let Ok(mut frame) = Framebuffer::<Rgb565>::new(a.out, 4, 4) {
        let color = Rgb565::new(byte, byte, 3);
        frame.paint(of_colors(color), |window, brush| triangle::fill(corners, window, brush));
    }
    a.out.first() == Some(&byte)
}

impl<L: Layout> Arguments<'_, L> {
    /// Of tiles: small enough for several, or 0.
    pub(crate) fn tile(&self) -> u16 {
        u16::from(self.byte(2) % 9)
    }

    /// Of pictures.
    pub(crate) fn map(&self) -> Affine {
        let [xx, xy, dx, yx, yy, dy] = self.numbers;
        // Small enough to be drawn, mostly.
        let factor = |n: i32| I16F16::from_bits(if self.flag { n } else { n >> 10 });
        let moved = |n: i32| I16F16::from_bits(if self.flag { n } else { n >> 8 });
        Affine { xx: factor(xx), xy: factor(xy), dx: moved(dx), yx: factor(yx), yy: factor(yy), dy: moved(dy) }
    }

    /// Of a pattern.
    pub(crate) fn rows(&self) -> [u8; 8] {
        let [a, b, c, d] = self.numbers[0].to_le_bytes();
        let [e, f, g, h] = self.numbers[1].to_le_bytes();
        [a, b, c, d, e, f, g, h]
    }

    fn steps(&self) -> Option<Steps> {
        line::clip(self.points[0], self.points[1], self.window)
    }

    fn extent(&self) -> Size {
        let [.., width, height] = self.numbers.map(i32::cast_unsigned);
        Size::new(width, height)
    }

    pub(crate) fn byte(&self, at: usize) -> u8 {
        self.bytes.get(at).copied().unwrap_or_default()
    }

    fn viewport(&self) -> Viewport {
        let [a, b, c, d, ..] = self.numbers;
        Viewport::from_bits([a, b], [c, d], self.areas[0])
    }
}

/// A sink that computes a sum of all spans.
fn add(sum: &mut usize) -> impl FnMut(ClippedSpan) + '_ {
    move |span| *sum = (*sum, span).answer()
}

/// What a shape says.
fn spans(shape: impl FnOnce(&mut dyn FnMut(ClippedSpan))) -> usize {
    let mut sum = 0;
    shape(&mut add(&mut sum));
    sum
}

/// A sink that computes a sum of what a function says of rows with rims.
struct SoftRows<'a, F>(&'a mut usize, F);

impl<R: Answer, F: Fn(SoftRow<'_>) -> R> Sink for SoftRows<'_, F> {
    fn span(&mut self, span: ClippedSpan) {
        *self.0 = (*self.0, span).answer();
    }

    fn soft_row(&mut self, row: SoftRow<'_>) {
        *self.0 = (*self.0, (self.1)(row)).answer();
    }
}

/// What a function says of the rows of a triangle.
fn soft_rows<R: Answer>(corners: [PointFx; 3], window: Rect, of: impl Fn(SoftRow<'_>) -> R) -> usize {
    let mut sum = 0;
    coverage::triangle(corners, &mut [], window, SoftRows(&mut sum, of));
    sum
}

/// A sink that computes a sum of all spans and levels.
struct Covered<'a>(&'a mut usize);

impl Sink for Covered<'_> {
    fn span(&mut self, span: ClippedSpan) {
        *self.0 = (*self.0, span).answer();
    }

    fn coverage(&mut self, span: ClippedSpan, levels: &[u8]) {
        *self.0 = levels.iter().fold((*self.0, span).answer(), |sum, &level| (sum, level).answer());
    }
}

/// What a shape with soft rims says, and whether it had memory enough.
fn covered(shape: impl FnOnce(&mut [CoverageSlot], &mut [i32], Covered<'_>) -> bool) -> (usize, bool) {
    let mut sum = 0;
    let is_drawn = with_scratch(|table, cells| shape(table, cells, Covered(&mut sum)));
    (sum, is_drawn)
}

/// The same with memory for parts of ellipses: their curves are cut anew for each strip and each band.
fn part_covered(shape: impl FnOnce(&mut [CoverageSlot], &mut [i32], Covered<'_>) -> bool) -> (usize, bool) {
    let mut sum = 0;
    let is_drawn = shape(&mut [CoverageSlot::EMPTY; 96], &mut [0; 800], Covered(&mut sum));
    (sum, is_drawn)
}

/// What is open by a rule, and painted in up to 32 pixels.
struct Flooded {
    window: Rect,
    bits: u32,
}

impl Flooded {
    fn bit(x: i32, y: i32) -> u32 {
        1_u32.wrapping_shl((x ^ y.wrapping_mul(5)).cast_unsigned())
    }
}

impl FloodTarget for Flooded {
    fn window(&self) -> Rect {
        self.window
    }

    fn is_open(&self, x: i32, y: i32) -> bool {
        self.bits & Self::bit(x, y) == 0
    }

    fn paint(&mut self, span: ClippedSpan) {
        for x in span.x0()..span.x1() {
            self.bits |= Self::bit(x, span.y());
        }
    }
}
