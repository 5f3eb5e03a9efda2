//! [`Transfer`] and [`Transfers`]: what goes over the wire, without the wire.
//!
//! An adapter of this crate does not know buses. It says which bytes a display is to be sent, piece by piece, and whoever has the bus sends
//! them: [`Spi`](crate::Spi) and [`I2c`](crate::I2c) do, blocking and asynchronously; a closure does, for any other driver; and an
//! interrupt at the end of a DMA transfer may ask for the next piece.
//!
//! ```text
//!   frame + damage  --->  adapter: Transfers  --- Transfer { command, data } --->  bus
//! ```

use core::future::Future;

/// A piece of what a display is sent: first the bytes of a command, then bytes of data. Either may be empty.
///
/// Displays with a data/command line want it low for `command` and high for `data`.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Transfer<'a> {
    /// A command, or none if `data` goes on with what the last command began.
    pub command: &'a [u8],
    /// Parameters of the command, or pixels.
    pub data: &'a [u8],
}

/// Transfers, one after the other.
///
/// It is an iterator whose items live until the next one: pixels that are converted on their way are all converted into the same few bytes.
/// ```
/// use embedded_raster::{surface::Rows, Bitmap, Index8, Rect};
/// use embedded_raster::pixel::Be;
/// use embedded_graphics_core::pixelcolor::Rgb565;
/// use embedded_raster_displays::{Tft, Transfers};
///
/// let picture = Bitmap::<Be<Rgb565>>::new(&[1, 2, 3, 4], 2, 1)?;
/// let mut transfers = Tft::<Rows<Be<Rgb565>>>::new().frame(&picture, [picture.window()]);
/// let mut wire = vec![];
/// while let Some(transfer) = transfers.next() {
///     wire.push((transfer.command.to_vec(), transfer.data.to_vec()));
/// }
/// assert_eq!(wire[0], (vec![0x2a], vec![0, 0, 0, 1])); // columns 0 to 1
/// assert_eq!(wire[1], (vec![0x2b], vec![0, 0, 0, 0])); // row 0
/// assert_eq!(wire[2], (vec![0x2c], vec![1, 2, 3, 4])); // pixels
/// # Ok::<(), embedded_raster::Error>(())
/// ```
pub trait Transfers {
    /// The next one; `None` after the last.
    fn next(&mut self) -> Option<Transfer<'_>>;

    /// Hands all of them to `send`, which may be any driver's function. The first error ends it.
    ///
    /// # Errors
    /// Those of `send`.
    fn send<E>(mut self, mut send: impl FnMut(Transfer<'_>) -> Result<(), E>) -> Result<(), E>
    where
        Self: Sized,
    {
        while let Some(transfer) = self.next() {
            send(transfer)?;
        }
        Ok(())
    }

    /// The same, and waits for each of them.
    ///
    /// # Errors
    /// Those of `send`.
    fn send_async<E>(
        mut self,
        mut send: impl AsyncFnMut(Transfer<'_>) -> Result<(), E>,
    ) -> impl Future<Output = Result<(), E>>
    where
        Self: Sized,
    {
        async move {
            while let Some(transfer) = self.next() {
                send(transfer).await?;
            }
            Ok(())
        }
    }
}

impl<T: Transfers> Transfers for &mut T {
    fn next(&mut self) -> Option<Transfer<'_>> {
        T::next(self)
    }
}

/// A single transfer of a few bytes.
pub(crate) struct Once<const C: usize, const D: usize> {
    command: [u8; C],
    data: [u8; D],
    is_sent: bool,
}

impl<const C: usize, const D: usize> Once<C, D> {
    pub(crate) const fn new(command: [u8; C], data: [u8; D]) -> Self {
        Self { command, data, is_sent: false }
    }
}

impl<const C: usize, const D: usize> Transfers for Once<C, D> {
    fn next(&mut self) -> Option<Transfer<'_>> {
        if core::mem::replace(&mut self.is_sent, true) {
            return None;
        }
        Some(Transfer { command: &self.command, data: &self.data })
    }
}
