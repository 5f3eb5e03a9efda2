//! [`Bands`]: a screen drawn part by part, in memory that holds only some of its rows.
//!
//! ```text
//!   +----------+
//!   | 0..16    |   draw the scene in the band, send its bytes
//!   +----------+
//!   | 16..32   |   draw the scene again ...
//!   +----------+
//!   | ...      |
//! ```
//! A band takes the coordinates of the screen and shows its own rows, so the program draws the same scene each time; what lies
//! elsewhere costs some comparisons. No pixel differs from drawing it whole. How many rows a band has is memory against time: the scene is
//! gone through once for each.

use core::{
    future::{poll_fn, Future},
    marker::PhantomData,
    pin::pin,
    task::Poll,
};

use crate::{
    error::BufferError,
    surface::{Frame, Layout},
};

/// The bands of a screen, from the top down.
///
/// For programs that own the loop; [`for_each_band`] is the loop.
/// ```
/// use embedded_raster::{present::Bands, surface::Rows, Canvas, Index8};
/// let mut ram = [0; 64 * 10];
/// let mut bands = Bands::<Rows<Index8>>::new(&mut ram, 64, 48, 10)?;
/// let mut sent = 0;
/// while let Some(mut band) = bands.next_band() {
///     band.clear(Index8::new(0));
///     band.fill_triangle([(5, 3), (60, 20), (20, 45)], Index8::new(7));
///     let rows = band.window().y0 as u16..band.window().y1 as u16;
///     sent += band.row_bytes(rows).len(); // to the display
/// }
/// assert_eq!(sent, 64 * 48);
/// # Ok::<(), embedded_raster::Error>(())
/// ```
#[derive(Debug)]
pub struct Bands<'a, L> {
    memory: &'a mut [u8],
    width: u16,
    height: u16,
    rows: u16,
    /// The first row of the next band.
    next: u16,
    layout: PhantomData<L>,
}

impl<'a, L: Layout> Bands<'a, L> {
    /// Bands of `rows` rows, of a screen of `width` x `height` pixels; the last one may have fewer. What was in `memory` is still there in
    /// the first band, and the pixels of each band in the next one.
    ///
    /// # Errors
    /// [`BufferError::TooSmall`] if a band does not fit into `memory`; [`BufferError::BandSplitsPage`] if rows share bytes that would lie in
    /// two bands; [`BufferError::BandOutsideScreen`] if a band has no rows.
    pub fn new(memory: &'a mut [u8], width: u16, height: u16, rows: u16) -> Result<Self, BufferError> {
        let first = rows.min(height);
        if first == 0 && height > 0 {
            return Err(BufferError::BandOutsideScreen { start: 0, end: 0, height });
        }
        Frame::<_, L>::band(&mut *memory, width, height, 0..first)?;
        Ok(Self { memory, width, height, rows, next: 0, layout: PhantomData })
    }

    /// The next band to draw on; `None` after the last.
    pub fn next_band(&mut self) -> Option<Frame<&mut [u8], L>> {
        let start = self.next;
        if start >= self.height {
            return None;
        }
        self.next = start.saturating_add(self.rows).min(self.height);
        Frame::band(&mut *self.memory, self.width, self.height, start..self.next).ok()
    }
}

/// Draws a screen of `width` x `height` pixels in bands of `rows` rows: calls `draw` with each band, from the top down, and `send`
/// with the same band when it is drawn. The first error of `send` ends it.
///
/// ```
/// use embedded_raster::{present::for_each_band, surface::Rows, BufferError, Canvas, Index4};
/// let mut ram = [0; 128 / 2 * 8];
/// let mut display = vec![];
/// for_each_band::<Rows<Index4>, BufferError>(
///     &mut ram, 128, 64, 8,
///     |band| {
///         band.clear(Index4::new(0));
///         band.draw_line((0, 0), (127, 63), Index4::new(15));
///     },
///     |band| {
///         display.extend_from_slice(band.row_bytes(band.window().y0 as u16..band.window().y1 as u16));
///         Ok(())
///     },
/// )?;
/// assert_eq!(display.len(), 128 * 64 / 2);
/// # Ok::<(), BufferError>(())
/// ```
/// # Errors
/// Those of [`Bands::new`], before anything is drawn, and those of `send`.
pub fn for_each_band<L: Layout, E: From<BufferError>>(
    memory: &mut [u8],
    width: u16,
    height: u16,
    rows: u16,
    mut draw: impl FnMut(&mut Frame<&mut [u8], L>),
    mut send: impl FnMut(Frame<&[u8], L>) -> Result<(), E>,
) -> Result<(), E> {
    let mut bands = Bands::new(memory, width, height, rows)?;
    while let Some(mut band) = bands.next_band() {
        draw(&mut band);
        send(band.as_bitmap())?;
    }
    Ok(())
}

/// [`for_each_band`] with two bands in memory: while one is sent, by a transfer that needs no processor, the next one is drawn. The frames
/// are the same.
///
/// `send` is polled once before the next band is drawn, which starts the transfer, and awaited after that.
///
/// # Errors
/// Those of [`Bands::new`] for either memory, before anything is drawn, and those of `send`.
pub async fn for_each_band_async<L: Layout, E: From<BufferError>>(
    memories: [&mut [u8]; 2],
    width: u16,
    height: u16,
    rows: u16,
    mut draw: impl FnMut(&mut Frame<&mut [u8], L>),
    mut send: impl AsyncFnMut(Frame<&[u8], L>) -> Result<(), E>,
) -> Result<(), E> {
    let [sent, drawn] = memories;
    let (mut sent, mut drawn) =
        (Bands::<L>::new(sent, width, height, rows)?, Bands::<L>::new(drawn, width, height, rows)?);
    if let Some(mut band) = sent.next_band() {
        draw(&mut band);
    }
    // The band before `sent.next` is drawn and not yet sent.
    let mut start = 0;
    while start < height {
        drawn.next = sent.next;
        {
            let band = Frame::band(&*sent.memory, width, height, start..sent.next)?;
            let mut sending = pin!(send(band));
            let started = poll_fn(|context| Poll::Ready(sending.as_mut().poll(context))).await;
            if let Some(mut band) = drawn.next_band() {
                draw(&mut band);
            }
            match started {
                Poll::Ready(result) => result?,
                Poll::Pending => sending.await?,
            }
        }
        start = sent.next;
        core::mem::swap(&mut sent, &mut drawn);
    }
    Ok(())
}
