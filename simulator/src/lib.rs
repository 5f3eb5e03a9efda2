//! Shows what embedded-raster draws, without hardware.
//!
//! A [`Picture`] is a copy of a framebuffer: indices with their palette, or colours. It becomes a PNG
//! ([`write_png`](Picture::write_png)), a preview in the terminal ([`preview`](Picture::preview)), a window ([`show`]), or
//! one side of a comparison ([`difference`](Picture::difference)). [`run`] runs a whole program, frame by frame: see [`desktop`].
//! ```text
//!   framebuffer + palette  --->  Picture  --->  PNG, terminal, window, difference
//! ```
//! [`world`] is a scene worth looking at: the countries of the world, ready to be drawn at any size and depth. [`paint`] is a
//! paint program, by scripts and in a window. [`teapot`] is a body in space, of patches or of an OBJ file, in many views.
//! [`svg`] draws paths as SVG has them. [`clock`] is a clock with soft rims, [`gauge`] a dial with a needle on one bit. [`film`]
//! makes APNG and GIF files of pictures, [`palettes`] reads colour tables, and [`quantize`]
//! makes them for a picture. [`scanout`] is a display over time: what is seen of a
//! buffer that is drawn on while it is shown. [`moving`] has what programs share that show a scene that moves, and
//! [`heat`](mod@heat) counts how often each pixel is drawn. [`overlay`] lays that over a picture, and what was sent, and how long frames
//! took. [`cookbook`] has the programs of the first hour.
//! ```
//! use embedded_graphics_core::geometry::Point;
//! use embedded_raster::{buffer_bytes, pixel::EGA, Canvas, Framebuffer, Index4};
//! use embedded_raster_simulator::Picture;
//! let mut ram = [0; buffer_bytes::<Index4>(64, 48)];
//! let mut frame = Framebuffer::<Index4>::new(&mut ram, 64, 48)?;
//! frame.draw_line(Point::new(0, 0), Point::new(63, 47), Index4::new(14));
//! println!("{}", Picture::indexed(&frame, &EGA).preview(40));
//! # Ok::<(), embedded_raster::Error>(())
//! ```

mod bands;
pub mod clock;
pub mod desktop;
mod difference;
pub mod film;
mod finish;
pub mod gauge;
pub mod heat;
mod moment;
pub mod moving;
pub mod overlay;
pub mod paint;
pub mod palettes;
mod picture;
mod png;
mod pnm;
mod preview;
pub mod quantize;
pub mod scanout;
pub mod svg;
pub mod teapot;
pub mod window;
pub mod world;

pub use bands::in_bands;
pub use desktop::run;
pub use difference::Difference;
pub use finish::finish;
pub use picture::{Picture, Pixels};
pub use window::{show, watch, Event, Key, Shot, WindowError};

#[doc = include_str!("../../docs/cookbook.md")]
pub mod cookbook {}
