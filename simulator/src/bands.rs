//! [`in_bands`]: a screen that is drawn through the memory of some of its rows.

use embedded_raster::{buffer_bytes, BufferError, Framebuffer, PixelFormat};

/// Draws a screen of `width` x `height` pixels in bands of `rows` rows, from the top down, and returns all of its bytes.
///
/// # Errors
/// The first one of `draw`.
pub fn in_bands<F: PixelFormat, E: From<BufferError>>(
    (width, height): (u16, u16),
    rows: u16,
    mut draw: impl FnMut(&mut Framebuffer<'_, F>) -> Result<(), E>,
) -> Result<Vec<u8>, E> {
    let rows = rows.clamp(1, height.max(1));
    let mut memory = vec![0; buffer_bytes::<F>(width, rows)];
    let mut whole = vec![];
    for start in (0..height).step_by(rows.into()) {
        let end = height.min(start.saturating_add(rows));
        memory.fill(0);
        let mut band = Framebuffer::band(&mut memory, width, height, start..end)?;
        draw(&mut band)?;
        whole.extend_from_slice(band.row_bytes(start..end));
    }
    Ok(whole)
}
