//! Sends frames of `embedded-raster` to displays: whole frames, bands, or the rectangles that have changed.
//!
//! | display | here | frame |
//! |---|---|---|
//! | ST7789, ST7735, ILI9341, ILI9488, GC9A01 and other MIPI controllers | [`tft`] | `Rows<Be<Rgb565>>`, indices through a palette, `Packed12`, any other converted |
//! | SSD1306, SSD1309, SH1106, SH1107 | [`oled`] | `Pages<Lsb0<BinaryColor>>` |
//! | Sharp memory LCDs | [`memory_lcd`] | `Rows<BinaryColor>`, also `Lsb0` |
//! | e-paper: black and white, three colours, seven colours | [`paper`] | `Rows<BinaryColor>`, `Planes<Index2>`, `Rows<Index4>` |
//! | LTDC layers, with a colour table | [`ltdc`] | `Rows<Index8>` and others |
//! | HUB75 matrices | [`hub75`] | any |
//! | WS2812 matrices | [`leds`] | any |
//! | any driver that embedded-graphics draws on | [`to_target`] | any |
//!
//! No driver is a dependency of this crate. An adapter says which bytes a display is sent, and in which order: its [`Transfers`]. Who sends
//! them is free to choose:
//!
//! - [`Spi`] and [`I2c`] send them over embedded-hal 1, or embedded-hal-async 1;
//! - a closure hands them to the bus of a driver that is there in any case:
//!
//! ```
//! use embedded_graphics_core::pixelcolor::Rgb565;
//! use embedded_raster::{pixel::Be, Bitmap, Rect};
//! use embedded_raster_displays::{Tft565, Transfer, Transfers};
//! use mipidsi::interface::Interface;
//!
//! /// Through mipidsi's interface: also in parallel, eight bits wide.
//! fn send<DI: Interface<Word = u8>>(frame: &Bitmap<Be<Rgb565>>, damage: &[Rect], di: &mut DI) -> Result<(), DI::Error> {
//!     Tft565::new().frame(frame, damage.iter().copied()).send(|Transfer { command, data }| match command {
//!         [command] => di.send_command(*command, data),
//!         _ => di.send_command(0x3c, data), // the pixels go on: RAMWRC
//!     })
//! }
//!
//! /// Through `display-interface`, as ssd1306 0.9 has it.
//! fn send_pages<DI: display_interface::WriteOnlyDataCommand>(
//!     transfers: impl Transfers,
//!     di: &mut DI,
//! ) -> Result<(), display_interface::DisplayError> {
//!     use display_interface::DataFormat::U8;
//!     transfers.send(|Transfer { command, data }| {
//!         di.send_commands(U8(command))?;
//!         di.send_data(U8(data))
//!     })
//! }
//! ```
//! - an interrupt calls [`Transfers::next`] when the transfer before has ended.
//!
//! A frame is only read: it is the same before and after. Bands are frames; `embedded_raster::present` makes them, and hands them to what
//! is here:
//! ```
//! use embedded_graphics_core::pixelcolor::{Rgb565, RgbColor};
//! use embedded_hal::{digital::OutputPin, spi::SpiDevice};
//! use embedded_raster::{pixel::Be, present::for_each_band, surface::Rows, Canvas};
//! use embedded_raster_displays::{BusError, Spi, Tft565};
//!
//! /// 240 x 240 pixels with memory for 24 rows.
//! fn show<D: SpiDevice, P: OutputPin>(spi: &mut Spi<D, P>) -> Result<(), BusError<D::Error, P::Error>> {
//!     let mut ram = [0; 240 * 24 * 2];
//!     for_each_band::<Rows<Be<Rgb565>>, _>(
//!         &mut ram, 240, 240, 24,
//!         |band| {
//!             band.clear(Rgb565::BLACK);
//!             band.fill_triangle([(9, 9), (200, 50), (100, 220)], Rgb565::RED);
//!         },
//!         |band| spi.send(Tft565::new().frame(&band, [band.window()])),
//!     )
//! }
//! ```
//! With two bands in memory, one is sent while the next is drawn. The window is opened once, so that a band's first transfer is its pixels:
//! ```
//! # use embedded_graphics_core::pixelcolor::{Rgb565, RgbColor};
//! # use embedded_hal::digital::OutputPin;
//! use embedded_hal_async::spi::SpiDevice;
//! use embedded_raster::{present::for_each_band_async, Frame, Rect};
//! # use embedded_raster::{pixel::Be, surface::Rows, Canvas};
//! # use embedded_raster_displays::{BusError, Spi, Tft565};
//! async fn show<D: SpiDevice, P: OutputPin>(spi: &mut Spi<D, P>) -> Result<(), BusError<D::Error, P::Error>> {
//!     let (mut one, mut other) = ([0; 240 * 24 * 2], [0; 240 * 24 * 2]);
//!     let display = Tft565::new();
//!     spi.send_async(display.window(Rect::new(0, 0, 240, 240))).await?;
//!     for_each_band_async::<Rows<Be<Rgb565>>, _>(
//!         [&mut one, &mut other], 240, 240, 24,
//!         |band| band.clear(Rgb565::BLACK),
//!         async |band: Frame<&[u8], Rows<Be<Rgb565>>>| spi.send_async(display.pixels(&band)).await,
//!     )
//!     .await
//! }
//! ```
//! Displays turn a picture by their registers, at no cost: [`Tft::orientation`], [`Oled::orientation`]. Then the frame is drawn as it is
//! seen.
#![no_std]
#![allow(clippy::doc_markdown, reason = "names of displays and chips")]

mod bus;
mod error;
pub mod hub75;
pub mod leds;
pub mod ltdc;
pub mod memory_lcd;
pub mod oled;
pub mod paper;
mod pieces;
mod target;
pub mod tft;
mod transfer;
mod windows;

pub use self::{
    bus::{ActiveHigh, BusError, I2c, NoPin, Spi},
    error::Error,
    oled::Oled,
    target::to_target,
    tft::{Tft, Tft444, Tft565, Tft666},
    transfer::{Transfer, Transfers},
};
