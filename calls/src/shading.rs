//! The list of what makes values over triangles, and colours of them, without a surface.

use embedded_graphics_core::pixelcolor::{Rgb565, Rgb888, RgbColor};
use embedded_raster::{
    geom::{At, Barycentric, Facet, Fast, Mix, Perspective, Plane, Runs},
    paint::{depth, Bayer, Outside},
    pipeline::{
        assemble, assemble_lines, assemble_points, shade_vertices, Facing, Line, LineTopology, Pipeline, Splat,
        Topology, Triangle, Vertex,
    },
    pixel::Depth16,
    surface::{
        texture::{Clamp, Mirror, Repeat, Texture, Tile},
        DepthBuffer,
    },
    Bitmap, Layout, Palette, Rect, Vec4,
};
use fixed::types::I16F16;

use crate::{
    answer::{sum, Answer},
    calls, Arguments,
};

calls! {
    /// Makes the call of a number below that of [`NAMES`], with a picture to take texels from.
    NAMES, call[L: Layout](on: &Bitmap<'_, Rgb565>, a)
    {
        let ([n, m, ..], [u, v]) = (a.numbers, [a.numbers[2], a.numbers[3]].map(I16F16::from_bits));
        let (key, palette) = (Rgb565::WHITE, Palette::new([Rgb888::RED, Rgb888::BLUE]));
        let (place, values) = (a.facet().map(|facet| facet.weights(a.places[3])), a.values());
    }
    [Facet]
    new => Facet::new(a.corners_fx()).is_ok();
    twice_area => a.facet().map(|facet| facet.twice_area());
    is_clockwise => a.facet().map(|facet| facet.is_clockwise());
    weights => a.facet().map(|facet| facet.weights(a.places[3]).weights);
    [Barycentric]
    is_inside => place.map(|place| place.is_inside());
    is_strictly_inside => place.map(|place| place.is_strictly_inside());
    parts => place.map(|place| place.parts());
    mix => place.map(|place: Barycentric| place.mix([n, m, 7]));
    [Mix]
    mix => place.map(|place| look(Values::mix(&|numbers| place.mix(numbers), values)));
    [Plane]
    new => a.facet().map(|facet| look(Plane::new(&facet, values).at(0, 0)));
    at => a.facet().map(|facet| {
        let [p, q, r, s, ..] = a.numbers.map(I16F16::from_bits);
        let seen = [(p, q), (q, r), (r, s)].map(|(w, place)| Perspective { w, value: (a.byte(0), place) });
        let runs = seen.map(|Perspective { w, value: (byte, place) }| Runs::<_, 16> { w, value: (byte, Fast((place, place))) });
        let (seen, runs) = (Plane::new(&facet, seen).at(n, m).value, Plane::new(&facet, runs).at(n, m).value);
        ((look(Plane::new(&facet, values).at(n, m)), i32::from(runs.0)), (i32::from(seen.0), seen.1.to_bits()))
    });
    each => a.facet().map(|facet| {
        let mut sum = 0;
        Plane::new(&facet, values).each(n, m, a.numbers[4].unsigned_abs() % 100, |values| sum = (sum, look(values)).answer());
        sum
    });
    [Bayer]
    threshold => (Bayer::<2>::threshold(a.points[0]), Bayer::<8>::threshold(a.points[0]));
    shade => Bayer::<4>::shade(a.byte(0), a.byte(1), a.points[0]);
    fine_shade => Bayer::<8>::fine_shade(a.halves(0)[0], a.byte(1), a.points[0]);
    moved => Bayer::<4>::moved(a.byte(0), a.byte(1), a.points[0]);
    [depth]
    less => depth::less(&n, &m);
    less_equal => depth::less_equal(&n, &m);
    greater => depth::greater(&n, &m);
    always => depth::always(&n, &m);
    [Texture]
    new => (Texture::new(on, (Clamp, Repeat)).is_some(), Texture::new(on, (Mirror, Tile)).is_some());
    nearest => (
        Texture::new(on, (Clamp, Repeat)).map(|texture| texture.nearest(u, v).g()),
        Texture::new(on, (Mirror, Tile)).map(|texture| texture.nearest(u, v).g()),
    );
    nearest_keyed => Texture::new(on, (Repeat, Mirror)).map(|texture| texture.nearest_keyed(u, v, key).is_some());
    nearest_through => Texture::new(&a.mask, (Repeat, Clamp))
        .map(|texture| texture.nearest_through(u, v, &palette).is_some());
    bilinear => (
        Texture::new(on, (Clamp, Repeat)).map(|texture| texture.bilinear(u, v).g()),
        Texture::new(on, (Mirror, Tile)).map(|texture| texture.bilinear(u, v).g()),
    );
    bilinear_keyed => Texture::new(on, (Repeat, Mirror)).map(|texture| texture.bilinear_keyed(u, v, key).is_some());
    bilinear_through => Texture::new(&a.mask, (Repeat, Clamp))
        .map(|texture| texture.bilinear_through(u, v, &palette).map(|color| color.r()));
    [Pipeline]
    new => Pipeline::new(a.halves(4)[0], a.halves(4)[1]).map(|pipeline| a.pieces(pipeline));
    cull => a.pieces(pipeline(a.window).cull(Facing::Back));
    front_is_clockwise => a.pieces(pipeline(a.window).cull(Facing::Front).front_is_clockwise());
    triangles => a.pieces(pipeline(a.window));
    whole_triangles => pipeline(a.window).whole_triangles([a.vertices()], |vertex| vertex, |_| ());
    indexed => pipeline(a.window)
        .indexed(Topology::Strip, &a.vertices(), a.bytes, |vertex| *vertex, |triangle| { sum(triangle.places()); });
    lines => pipeline(a.window).lines([a.ends()], |vertex| vertex, |_| ());
    points => pipeline(a.window).points(a.vertices(), |vertex| vertex, |_| ());
    [Vertex]
    new => Vertex::new(Vec4::from_bits([n, m, n, m]), ()).position.dot(Vec4::from_bits([m, n, m, n]));
    [vertex]
    shade_vertices => shade_vertices(&a.places, &mut [Vertex::default(); 4], |place, number| {
        Vertex::new(Vec4::from_bits([place.x.to_bits(), place.y.to_bits(), 0, 1 << 16]), number)
    }).map(|shaded| sum(shaded.iter().map(|vertex| vertex.values)));
    [assembly]
    assemble => assemble(Topology::Fan, a.places.as_slice(), a.starts).map(|fan| sum(fan.map(|corners| corners.map(|&place| place))));
    assemble_lines => assemble_lines(LineTopology::Loop, a.places.as_slice(), a.starts)
        .map(|lines| sum(lines.map(|ends| ends.map(|&place| place))));
    assemble_points => assemble_points(a.places.as_slice(), a.starts).map(|points| sum(points.copied()));
    [Line]
    places => a.of_lines(|line| line.places().answer());
    ends => a.of_lines(|line| sum(line.ends().map(|end| end.position.dot(end.position))));
    number => a.of_lines(|line| line.number().answer());
    [Splat]
    place => a.of_points(|point| point.place().answer());
    vertex => a.of_points(|point| point.vertex().position.dot(point.vertex().position).answer());
    number => a.of_points(|point| point.number().answer());
    [Triangle]
    places => a.of_pieces(|triangle| triangle.places().answer());
    corners => a.of_pieces(|triangle| sum(triangle.corners().map(|corner| corner.position.dot(corner.position))));
    facing => a.of_pieces(|triangle| (triangle.facing() == Facing::Front).into());
    number => a.of_pieces(|triangle| triangle.number().answer());
}

/// What changes over triangles: of each kind one.
type Values = ((u8, u16, Fast<u16>), (i32, u32, I16F16), [Fast<i16>; 2], (Rgb565, Fast<Rgb565>, Rgb888), At);

fn look((small, (n, bits, fixed), [first, second], (packed, fast, color), At(at)): Values) -> usize {
    let numbers = ((small.0, (small.1, small.2 .0)), (n, (bits, fixed)));
    let levels =
        [packed.b(), packed.g(), packed.r(), fast.0.b(), fast.0.g(), fast.0.r(), color.b(), color.g(), color.r()];
    ((numbers, levels), ([first, second].map(|fast| i32::from(fast.0)), at)).answer()
}

impl<L: Layout> Arguments<'_, L> {
    pub(crate) fn facet(&self) -> Option<Facet> {
        Facet::new(self.corners_fx()).ok()
    }

    /// What a gradient is beyond its ends.
    pub(crate) fn outside(&self) -> Outside {
        [Outside::Clamp, Outside::Repeat, Outside::Mirror].get(self.corners.len() % 3).copied().unwrap_or_default()
    }

    /// At three corners.
    fn values(&self) -> [Values; 3] {
        [0, 1, 2].map(|i| {
            let ([low, high], [next, _]) = (self.halves(i), self.halves(i.wrapping_add(1)));
            let [_, blue, green, red] = [
                self.byte(i),
                self.byte(i.wrapping_add(3)),
                self.byte(i.wrapping_add(6)),
                self.byte(i.wrapping_add(9)),
            ];
            let number = self.numbers.get(i).copied().unwrap_or_default();
            (
                (red, low, Fast(high)),
                (number, number.cast_unsigned(), I16F16::from_bits(number)),
                [Fast(low.cast_signed()), Fast(next.cast_signed())],
                (Rgb565::new(red, green, blue), Fast(Rgb565::new(blue, red, green)), Rgb888::new(red, green, blue)),
                At::default(),
            )
        })
    }

    /// Corners in clip coordinates: near the places on a screen of 64 pixels, or anywhere.
    pub(crate) fn vertices(&self) -> [Vertex<u8>; 3] {
        let mut number = 0..usize::MAX;
        self.corners_fx().map(|corner| {
            let i = number.next().unwrap_or_default();
            let [z, w] = [i, i.wrapping_add(3)].map(|i| self.numbers.get(i).copied().unwrap_or_default());
            let [x, y] = [corner.x, corner.y].map(|n| n.to_bits().wrapping_mul(8).wrapping_sub(1 << 16));
            let [z, w] = if self.flag { [z, w] } else { [z & 0xffff, 1 << 16] };
            Vertex::new(Vec4::from_bits([x, y.wrapping_neg(), z, w]), self.byte(i))
        })
    }

    fn pieces(&self, pipeline: Pipeline) -> u32 {
        pipeline.triangles([self.vertices()], |vertex| vertex, |_| ())
    }

    /// The first two of those corners.
    pub(crate) fn ends(&self) -> [Vertex<u8>; 2] {
        let [a, b, _] = self.vertices();
        [a, b]
    }

    fn of_lines(&self, look: impl Fn(&Line<u8>) -> usize) -> usize {
        let mut sum = 0;
        pipeline(self.window).lines([self.ends()], |vertex| vertex, |line| sum = (sum, look(line)).answer());
        sum
    }

    fn of_points(&self, look: impl Fn(&Splat<u8>) -> usize) -> usize {
        let mut sum = 0;
        pipeline(self.window).points(self.vertices(), |vertex| vertex, |point| sum = (sum, look(point)).answer());
        sum
    }

    fn of_pieces(&self, look: impl Fn(&Triangle<u8>) -> usize) -> usize {
        let mut sum = 0;
        pipeline(self.window).triangles(
            [self.vertices()],
            |vertex| vertex,
            |triangle| sum = (sum, look(triangle)).answer(),
        );
        sum
    }

    /// The corners as a plane of depths and of a level has them.
    pub(crate) fn depths(&self) -> [(u16, u8); 3] {
        [0, 1, 2].map(|i| (self.halves(i)[0], self.byte(i)))
    }
}

/// Lends a depth buffer whose first pixel is that of a window. It is small: what lies beyond has no depth.
pub(crate) fn with_depths<R: Default>(window: Rect, act: impl FnOnce(&mut DepthBuffer<'_, Depth16>) -> R) -> R {
    let mut memory = [0x80; 16 * 16 * 2];
    let Ok(mut buffer) = DepthBuffer::<Depth16>::new(&mut memory, 16, 16) else { return R::default() };
    // A view may begin left of and above what it shows.
    act(&mut buffer.view(Rect { x0: window.x0.wrapping_neg(), y0: window.y0.wrapping_neg(), x1: 16, y1: 16 }))
}

/// For a screen that ends where a window does.
pub(crate) fn pipeline(window: Rect) -> Pipeline {
    const SMALL: Pipeline = match Pipeline::new(64, 64) {
        Ok(pipeline) => pipeline,
        Err(_) => panic!("it is small"),
    };
    // Windows without pixels have no place, and some are too large.
    let side = |n: i32| u16::try_from(n).ok().filter(|&n| !window.is_empty() && n <= 4_096).unwrap_or(64);
    Pipeline::new(side(window.x1), side(window.y1)).unwrap_or(SMALL)
}
