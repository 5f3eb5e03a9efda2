//! The peers: tiny-skia and raqote on premultiplied pixels of 32 bits, and `image`, which stretches a picture and then puts it down.

use super::Way;

#[cfg(feature = "peers-pictures")]
mod all {
    use image::{imageops, Rgba, RgbaImage};
    use raqote::{
        AntialiasMode, DrawOptions, DrawTarget, ExtendMode, FilterMode, Image, PathBuilder, SolidSource, Source,
        Transform,
    };
    use tiny_skia::{Pixmap, PixmapPaint};

    use super::super::{Job, Texel, Way, SIDE};
    use crate::frame::{HEIGHT, WIDTH};

    /// Red, green, blue and alpha of the texel in a column and a row: it says where it is.
    fn color(x: u16, y: u16) -> [u8; 4] {
        [x as u8, y as u8, 255, 255]
    }

    fn texel([r, g, _, a]: [u8; 4]) -> Texel {
        (a != 0).then(|| (r.into(), g.into()))
    }

    fn places() -> impl Iterator<Item = (u16, u16)> {
        (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (x, y)))
    }

    pub(super) struct TinySkia(Pixmap, Pixmap);

    impl TinySkia {
        pub(super) fn new() -> Self {
            let pixmap = |width, height| Pixmap::new(width, height).expect("not empty");
            let (screen, mut picture) = (pixmap(WIDTH as u32, HEIGHT as u32), pixmap(SIDE.into(), SIDE.into()));
            for (pixel, (x, y)) in picture.data_mut().chunks_exact_mut(4).zip(places()) {
                pixel.copy_from_slice(&color(x, y));
            }
            Self(screen, picture)
        }
    }

    impl Way for TinySkia {
        fn name(&self) -> &'static str {
            "tiny-skia"
        }

        fn can(&self, _: &Job) -> bool {
            true
        }

        fn clear(&mut self) {
            self.0.data_mut().fill(0);
        }

        fn draw(&mut self, job: &Job) {
            let [xx, yx, xy, yy, dx, dy] = job.floats();
            let map = tiny_skia::Transform::from_row(xx, yx, xy, yy, dx, dy);
            self.0.draw_pixmap(0, 0, self.1.as_ref(), &PixmapPaint::default(), map, None);
        }

        fn texels(&self) -> Option<Vec<Texel>> {
            Some(self.0.data().chunks_exact(4).map(|pixel| texel([pixel[0], pixel[1], pixel[2], pixel[3]])).collect())
        }
    }

    pub(super) struct Raqote(DrawTarget, Vec<u32>);

    impl Raqote {
        pub(super) fn new() -> Self {
            let argb = |(x, y)| {
                let [r, g, b, a] = color(x, y);
                u32::from_be_bytes([a, r, g, b])
            };
            Self(DrawTarget::new(WIDTH, HEIGHT), places().map(argb).collect())
        }
    }

    impl Way for Raqote {
        fn name(&self) -> &'static str {
            "raqote"
        }

        fn can(&self, _: &Job) -> bool {
            true
        }

        fn clear(&mut self) {
            self.0.clear(SolidSource { r: 0, g: 0, b: 0, a: 0 });
        }

        /// A path in the picture of a map.
        fn draw(&mut self, job: &Job) {
            let [xx, yx, xy, yy, dx, dy] = job.floats();
            let map = Transform::new(xx, yx, xy, yy, dx, dy);
            let Some(back) = map.inverse() else { return };
            let mut path = PathBuilder::new();
            path.rect(0.0, 0.0, SIDE.into(), SIDE.into());
            let image = Image { width: SIDE.into(), height: SIDE.into(), data: &self.1 };
            let source = Source::Image(image, ExtendMode::Pad, FilterMode::Nearest, back);
            let options = DrawOptions { antialias: AntialiasMode::None, ..DrawOptions::new() };
            self.0.fill(&path.finish().transform(&map), &source, &options);
        }

        fn texels(&self) -> Option<Vec<Texel>> {
            let rgba = |pixel: &u32| {
                let [a, r, g, b] = pixel.to_be_bytes();
                [r, g, b, a]
            };
            Some(self.0.get_data().iter().map(|pixel| texel(rgba(pixel))).collect())
        }
    }

    pub(super) struct ImageOps(RgbaImage, RgbaImage);

    impl ImageOps {
        pub(super) fn new() -> Self {
            let picture = RgbaImage::from_fn(SIDE.into(), SIDE.into(), |x, y| Rgba(color(x as u16, y as u16)));
            Self(RgbaImage::new(WIDTH as u32, HEIGHT as u32), picture)
        }
    }

    impl Way for ImageOps {
        fn name(&self) -> &'static str {
            "image"
        }

        fn can(&self, job: &Job) -> bool {
            matches!(job, Job::Stretched(_))
        }

        fn clear(&mut self) {
            self.0.fill(0);
        }

        fn draw(&mut self, job: &Job) {
            let Job::Stretched(to) = job else { return };
            let stretched = imageops::resize(&self.1, to.width(), to.height(), imageops::FilterType::Nearest);
            imageops::replace(&mut self.0, &stretched, to.x0.into(), to.y0.into());
        }

        fn texels(&self) -> Option<Vec<Texel>> {
            Some(self.0.pixels().map(|pixel| texel(pixel.0)).collect())
        }
    }
}

/// Those that were compiled.
pub(super) fn ways() -> Vec<Box<dyn Way>> {
    #[cfg(feature = "peers-pictures")]
    return vec![Box::new(all::TinySkia::new()), Box::new(all::Raqote::new()), Box::new(all::ImageOps::new())];
    #[cfg(not(feature = "peers-pictures"))]
    vec![]
}
