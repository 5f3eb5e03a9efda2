//! [`draw`]: a mesh through the pipeline, to pixels of any depth.

use embedded_graphics_core::geometry::Point;
use embedded_graphics_core::pixelcolor::{PixelColor, Rgb565, Rgb888};
use embedded_raster::{
    buffer_bytes,
    geom::{
        space::light::{diffuse, half_way, specular, Gloss},
        Mix, Perspective, Varying,
    },
    paint::depth,
    pipeline::{Facing, Fragment, Pipeline, Vertex},
    pixel::{row_bytes, Depth16, Id16, Id32, Xrgb8888},
    surface::DepthBuffer,
    Angle, Canvas, ClippedSpan, Error, Framebuffer, Index1, Index2, Index4, Index8, Mat4, PixelFormat, Rect, Surface,
    Vec3,
};
use fixed::types::{I16F16, I48F16};

use super::{
    ink::{Ink, Inks},
    mesh::{Corner, Mesh},
    view::{grey, heat, lit, told_apart, View, BACK, BACKGROUND, CLAY, DARK, FRONT, LIGHT},
};
use crate::picture::Picture;

/// How a body is seen: the eye looks along -z at its middle, and the light comes from above on the left.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Camera {
    /// Columns of the picture, up to 4,096.
    pub width: u16,
    /// Rows of the picture, up to 4,096.
    pub height: u16,
    /// How far the body is turned around its own axis, which points upwards.
    pub yaw: Angle,
    /// How far it is tilted towards the viewer after that.
    pub pitch: Angle,
    /// How much nearer than usual the eye is: 1 shows the whole body from all sides. From 1/16 to 16.
    pub zoom: I16F16,
}

impl Camera {
    /// The whole body, as it looks best.
    pub fn new(width: u16, height: u16) -> Self {
        Self { width, height, yaw: Angle::degrees(-25), pitch: Angle::degrees(22), zoom: I16F16::ONE }
    }

    /// How near triangles should follow a surface: a quarter of a pixel in the middle of the body. Where triangles themselves are
    /// to be seen, they are larger.
    pub fn tolerance(&self, view: View) -> I16F16 {
        // The ball around the body is as high, or as wide, as the picture.
        let pixels = i32::from(self.width.min(self.height).max(1));
        let quarter = I16F16::from_num(Mesh::RADIUS) * 2 / (4 * pixels);
        match view {
            View::Wire | View::Flat | View::Id | View::Barycentric => quarter * 8,
            _ => quarter,
        }
    }

    /// The body turned, as seen from the eye but not from where it is.
    fn turn(&self) -> Mat4 {
        Mat4::rotate_x(self.pitch) * Mat4::rotate_y(self.yaw)
    }

    /// From the body to clip coordinates. Depths are from 0 to 1 from its nearest corner to its furthest one.
    fn clip(&self, mesh: &Mesh) -> Mat4 {
        let [width, height] = [self.width, self.height].map(|n| i32::from(n.clamp(1, 4096)));
        let radius = I16F16::from_num(Mesh::RADIUS);
        // 1 / sin(37 degrees / 2) = 3.15 radii away, a ball is as high as the picture. A narrow one takes a longer way.
        let usual = I48F16::from(radius) * 13 / 4 * i64::from(height.max(width)) / i64::from(width);
        let zoom = I48F16::from(self.zoom.clamp(I16F16::ONE / 16, I16F16::from_num(16)));
        let away: I16F16 = (usual / zoom).min(I48F16::from_num(20_000)).to_num();
        let turn = self.turn();
        let heights = || mesh.triangles.iter().flatten().map(|corner| turn.transform_point(corner.place).z);
        let (low, high) = (heights().min().unwrap_or_default(), heights().max().unwrap_or_default());
        let room = radius / 64;
        let near = (away - high - room).max(room);
        let far = (away - low).max(near) + room;
        let lens = Mat4::perspective(Angle::degrees(37), I16F16::from_num(width) / height, near, far);
        lens * Mat4::translate(Vec3::new(I16F16::ZERO, I16F16::ZERO, -away)) * turn
    }
}

/// A drawn body, and what it took.
#[derive(Clone, Debug)]
pub struct Drawing {
    /// What it looks like.
    pub picture: Picture,
    /// Triangles of the mesh.
    pub triangles: usize,
    /// Pixels that the fragment stage was asked for.
    pub fragments: u64,
    /// Bytes of the framebuffer, or of a band of it.
    pub color: usize,
    /// Bytes of the depth buffer.
    pub depth: usize,
    /// Bytes of numbers of triangles, or of counters.
    pub scratch: usize,
}

/// Draws at a depth of 1, 2, 4, 8, 16, 24 or 32 bits; any other number stands for the last one.
///
/// * `band`: how many rows there is memory for; all of them unless told.
///
/// # Errors
/// If a picture has more than 4,096 columns or rows.
pub fn draw(bits: u32, mesh: &Mesh, view: View, camera: &Camera, band: Option<u16>) -> Result<Drawing, Error> {
    match bits {
        1 => draw_as::<Index1>(mesh, view, camera, band),
        2 => draw_as::<Index2>(mesh, view, camera, band),
        4 => draw_as::<Index4>(mesh, view, camera, band),
        8 => draw_as::<Index8>(mesh, view, camera, band),
        16 => draw_as::<Rgb565>(mesh, view, camera, band),
        24 => draw_as::<Rgb888>(mesh, view, camera, band),
        _ => draw_as::<Xrgb8888>(mesh, view, camera, band),
    }
}

/// Draws with pixels of one kind.
///
/// # Errors
/// As [`draw`].
pub fn draw_as<C: Ink>(mesh: &Mesh, view: View, camera: &Camera, band: Option<u16>) -> Result<Drawing, Error> {
    let Camera { width, height, .. } = *camera;
    let rows = band.unwrap_or(height).clamp(1, height.max(1));
    let inks = Inks::new(view.palette());
    let pipeline = Pipeline::new(width, height)?;
    let scene = Scene { mesh, pipeline, inks: &inks, clip: camera.clip(mesh), light: Light::new(camera) };
    let bytes = |row: usize| row * usize::from(rows);
    // Numbers of 16 bits are enough for most bodies.
    let has_few = u16::try_from(mesh.triangles.len()).is_ok();
    let (has_depth, row_of_scratch) = match view {
        View::Overdraw => (false, usize::from(width)),
        View::Id if has_few => (true, row_bytes::<Id16>(width)),
        View::Id => (true, row_bytes::<Id32>(width)),
        _ => (true, 0),
    };
    let color_bytes = bytes(row_bytes::<C>(width));
    let depth_bytes = if has_depth { bytes(row_bytes::<Depth16>(width)) } else { 0 };
    let scratch_bytes = bytes(row_of_scratch);
    let mut color = vec![0; color_bytes];
    let mut depth = vec![0; depth_bytes];
    let mut scratch = vec![0; scratch_bytes];
    // What a display would have received: each band is sent before the next one is drawn in the same memory.
    let mut screen = Vec::with_capacity(buffer_bytes::<C>(width, height));
    let mut fragments = 0;
    for start in (0..height).step_by(rows.into()) {
        let band = start..height.min(start.saturating_add(rows));
        let mut frame = Framebuffer::<C>::band(&mut color, width, height, band.clone())?;
        frame.fill_window(C::plain(BACKGROUND, &inks));
        scratch.fill(0);
        fragments += if view == View::Overdraw {
            scene.overdraw(&mut frame, &mut scratch)
        } else {
            let mut depth = DepthBuffer::<Depth16>::band(&mut depth, width, height, band.clone())?;
            depth.clear(Depth16::MAX);
            if view == View::Wire {
                scene.wire(&mut frame, &mut depth)
            } else if view != View::Id {
                scene.faces(view, &mut frame, &mut depth)
            } else if has_few {
                let mut ids = Framebuffer::<Id16>::band(&mut scratch, width, height, band.clone())?;
                let id = |number| Id16(u16::try_from(number).unwrap_or_default());
                scene.ids(&mut frame, &mut depth, &mut ids, id, |id| id.0.into())
            } else {
                let mut ids = Framebuffer::<Id32>::band(&mut scratch, width, height, band.clone())?;
                scene.ids(&mut frame, &mut depth, &mut ids, Id32, |id| id.0)
            }
        };
        screen.extend_from_slice(frame.row_bytes(band));
    }
    let picture = C::picture(&Framebuffer::<C>::new(&mut screen, width, height)?, &inks);
    Ok(Drawing {
        picture,
        triangles: mesh.triangles.len(),
        fragments,
        color: color_bytes,
        depth: depth_bytes,
        scratch: scratch_bytes,
    })
}

/// The brightness of a front and of a back, from 0 to 255.
type Tones = [u8; 2];

/// The light, which stays where it is when the body turns.
struct Light {
    turn: Mat4,
    direction: Vec3,
    half_way: Vec3,
    gloss: Gloss,
}

impl Light {
    fn new(camera: &Camera) -> Self {
        let to_light = Vec3::whole(-4, 6, 7).normalize();
        // The eye is far away: for all places it is in the same direction.
        Self { turn: camera.turn(), direction: to_light, half_way: half_way(to_light, Vec3::Z), gloss: Gloss::new(40) }
    }

    /// A direction of the body, as the eye sees it.
    fn normal(&self, normal: Vec3) -> Vec3 {
        self.turn.transform_direction(normal)
    }

    fn tones(&self, normal: Vec3) -> Tones {
        let normal = self.normal(normal);
        [normal, -normal].map(|normal| {
            let (matt, shine) =
                (diffuse(normal, self.direction), specular(normal, self.direction, self.half_way, &self.gloss));
            // 36 + 156 + 63 = 255: up to 192, the material has its own colour.
            (36 + (matt * 156 + shine * 63).round().to_num::<u16>()).try_into().unwrap_or(u8::MAX)
        })
    }
}

/// The tone of the side that is seen.
fn tone([front, back]: Tones, facing: Facing) -> u8 {
    match facing {
        Facing::Front => front,
        Facing::Back => back,
    }
}

/// Squares of the chequerboard, in two colours.
fn material([u, v]: [I16F16; 2]) -> Rgb888 {
    let is_light = (u.to_num::<i32>() ^ v.to_num::<i32>()) & 1 == 0;
    if is_light {
        LIGHT
    } else {
        DARK
    }
}

/// A direction as a colour: each coordinate from -1 to 1 becomes a channel from 0 to 255.
fn channels(normal: Vec3) -> [u8; 3] {
    normal
        .to_bits()
        .map(|n| u8::try_from(((n + 65_536) * 255 + 65_536) >> 17).unwrap_or(if n < 0 { 0 } else { u8::MAX }))
}

struct Scene<'a> {
    mesh: &'a Mesh,
    pipeline: Pipeline,
    inks: &'a Inks,
    clip: Mat4,
    light: Light,
}

impl Scene<'_> {
    /// What the vertex stage is given: each corner with its triangle.
    fn corners(&self) -> impl Iterator<Item = [(&[Corner; 3], usize); 3]> {
        self.mesh.triangles.iter().map(|triangle| [0, 1, 2].map(|corner| (triangle, corner)))
    }

    /// Draws what the nearest triangles show.
    ///
    /// What is given to [`surface`](Self::surface) is all that differs from view to view: the values of a corner, which change over
    /// a triangle, and the colour that a pixel has by them.
    fn faces<C: Ink>(&self, view: View, on: &mut Framebuffer<C>, depth: &mut DepthBuffer<Depth16>) -> u64 {
        let light = &self.light;
        let ink = |color, at| C::ink(color, at, self.inks);
        match view {
            View::Flat => {
                let values = |face: &_, _, _| light.tones(Mesh::face_normal(face));
                self.surface(on, depth, values, |f| ink(lit(CLAY, tone(f.values, f.facing)), f.at))
            }
            // Brightness changes evenly on the screen, which nobody sees. A place on the texture has to change as it does in space.
            View::Textured => {
                let values = |face: &[Corner; 3], i: usize, w| {
                    (light.tones(face[i].normal), Perspective { w, value: face[i].texel })
                };
                self.surface(on, depth, values, |f| {
                    let (tones, texel) = f.values;
                    ink(lit(material(texel.value), tone(tones, f.facing)), f.at)
                })
            }
            View::Depth => {
                self.surface(on, depth, |_, _, _| (), |f| ink(grey(u8::MAX - (f.depth >> 8).to_le_bytes()[0]), f.at))
            }
            View::Normal => {
                let values = |face: &[Corner; 3], i: usize, _| channels(light.normal(face[i].normal));
                self.surface(on, depth, values, |f| {
                    let [r, g, b] = match f.facing {
                        Facing::Front => f.values,
                        Facing::Back => f.values.map(|n| u8::MAX - n),
                    };
                    ink(Rgb888::new(r, g, b), f.at)
                })
            }
            View::Barycentric => {
                let values = |_: &_, i, _| [0, 1, 2].map(|corner| if corner == i { u8::MAX } else { 0 });
                self.surface(on, depth, values, |f| {
                    let [r, g, b] = f.values;
                    ink(Rgb888::new(r, g, b), f.at)
                })
            }
            _ => {
                let values = |face: &[Corner; 3], i: usize, _| light.tones(face[i].normal);
                self.surface(on, depth, values, |f| ink(lit(CLAY, tone(f.values, f.facing)), f.at))
            }
        }
    }

    /// Takes all triangles through the pipeline, to a surface with a depth buffer. `values` is also told the w of the corner, its
    /// distance. Returns how many fragments there were.
    fn surface<S: Surface, V: Mix + Varying>(
        &self,
        on: &mut S,
        buffer: &mut DepthBuffer<Depth16>,
        values: impl Fn(&[Corner; 3], usize, I16F16) -> V,
        color: impl Fn(Fragment<V, u16>) -> S::Color,
    ) -> u64 {
        let mut fragments = 0;
        self.pipeline.triangles(
            self.corners(),
            |(face, i)| {
                let position = self.clip.transform_point(face[i].place);
                Vertex::new(position, values(face, i, position.w))
            },
            |triangle| {
                triangle.fill_depth(on, buffer, depth::less, |fragment| {
                    fragments += 1;
                    Some(color(fragment))
                });
            },
        );
        fragments
    }

    /// Deferred: first the numbers of the nearest triangles, then, pixel by pixel, the colour that belongs to a number.
    fn ids<C: Ink, I: PixelFormat<Color = I> + PixelColor>(
        &self,
        on: &mut Framebuffer<C>,
        depth: &mut DepthBuffer<Depth16>,
        ids: &mut Framebuffer<I>,
        id: impl Fn(u32) -> I,
        number: impl Fn(I) -> u32,
    ) -> u64 {
        let fragments = self.surface(ids, depth, |_, _, _| (), |f| id(f.number));
        for at in pixels(on.window()) {
            match ids.get(at).map_or(0, &number) {
                0 => {}
                number => on.draw_point(at, C::ink(told_apart(number - 1), at, self.inks)),
            }
        }
        fragments
    }

    /// Counts how often each pixel is painted, on a surface of counters.
    fn overdraw<C: Ink>(&self, on: &mut Framebuffer<C>, counters: &mut [u8]) -> u64 {
        let window = on.window();
        let mut counts = Counts { window, counters, all: 0 };
        self.pipeline.triangles(
            self.corners(),
            |(face, i)| Vertex::new(self.clip.transform_point(face[i].place), ()),
            |triangle| triangle.fill(&mut counts, |_| Some(Index1::MAX)),
        );
        for at in pixels(window) {
            match counts.counters[counts.place(at)] {
                0 => {}
                times => on.draw_point(at, C::ink(heat(times), at, self.inks)),
            }
        }
        counts.all
    }

    /// Draws the sides of all triangles that no triangle hides: first those that only backs have, then those of fronts.
    ///
    /// The triangles are filled with the background, set back a little, so that their sides are in front of them.
    fn wire<C: Ink>(&self, on: &mut Framebuffer<C>, buffer: &mut DepthBuffer<Depth16>) -> u64 {
        let (mut fragments, mut is_front) = (0, vec![false; self.mesh.triangles.len()]);
        let background = C::plain(BACKGROUND, self.inks);
        let vertex = |place: Vec3| Vertex::new(self.clip.transform_point(place), ());
        self.pipeline.triangles(
            self.mesh.triangles.iter().map(|triangle| triangle.map(|corner| corner.place)),
            vertex,
            |triangle| {
                is_front[triangle.number() as usize - 1] = triangle.facing() == Facing::Front;
                triangle.fill_behind(on, buffer, depth::less_equal, |_| {
                    fragments += 1;
                    Some(background)
                });
            },
        );
        let sides = self.mesh.sides();
        for (color, is_wanted) in [(BACK, false), (FRONT, true)] {
            let color = C::plain(color, self.inks);
            let these =
                sides.iter().filter(|side| side.triangles.iter().any(|&triangle| is_front[triangle]) == is_wanted);
            self.pipeline.lines(these.map(|side| side.ends), vertex, |line| {
                line.draw_depth(on, buffer, depth::less_equal, |_| {
                    fragments += 1;
                    Some(color)
                });
            });
        }
        fragments
    }
}

/// Counts how often its pixels are painted: up to 255 times each.
struct Counts<'a> {
    window: Rect,
    counters: &'a mut [u8],
    /// Of all pixels together.
    all: u64,
}

impl Counts<'_> {
    /// The counter of a pixel.
    fn place(&self, at: Point) -> usize {
        usize::try_from((at.y - self.window.y0) * self.window.x1 + at.x).unwrap_or(usize::MAX)
    }
}

impl Surface for Counts<'_> {
    type Color = Index1;

    fn window(&self) -> Rect {
        self.window
    }

    fn fill_span(&mut self, span: ClippedSpan, _: Index1) {
        let first = self.place(Point::new(span.x0(), span.y()));
        for times in &mut self.counters[first..][..span.len() as usize] {
            *times = times.saturating_add(1);
        }
        self.all += u64::from(span.len());
    }
}

/// The pixels of a window, row by row.
fn pixels(window: Rect) -> impl Iterator<Item = Point> {
    (window.y0..window.y1).flat_map(move |y| (window.x0..window.x1).map(move |x| Point::new(x, y)))
}
