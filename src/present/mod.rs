//! Frames on their way to a display: who owns which buffer when, and pictures drawn in bands.
//!
//! ```text
//!   the program draws          the display shows
//!
//!   begin ---> a buffer ---> finish ---> waiting ---> flip ---> shown
//!     ^                                    |                      |
//!     '------------- free <----------------+----------------------'
//!                             replaced by a newer frame    no longer shown
//! ```
//!
//! A picture that is sent to the display while it is drawn *tears*: the upper part is of one frame and the lower part of another. So there
//! are several buffers, and one is shown while another is drawn:
//!
//! | buffers | the program | what is seen |
//! |---|---|---|
//! | 1 | waits while the frame is sent | whole frames, if they are sent after they are drawn |
//! | 2 | waits for the display once a frame | whole frames |
//! | 3 | never waits | whole frames, the newest one at each refresh |
//!
//! [`Swapchain`] is that picture as a state machine, for a program that draws and flips in one place, or that keeps it behind a
//! lock. [`Queues`] hands the same buffers to an interrupt or to another core, without a lock and without `unsafe`. A buffer
//! is moved from hand to hand, so nobody can draw on one that is shown: the compiler sees to that.
//!
//! A buffer that comes back holds an older frame. Its [age](Buffer::age) tells which, so that a program need not draw what has not
//! changed since.
//!
//! Where memory holds only some rows of a screen, [`Bands`] draws it part by part.

mod bands;
mod buffers;
mod queues;

pub use self::{
    bands::{for_each_band, for_each_band_async, Bands},
    buffers::{Buffer, Swapchain, Vsync},
    queues::{Display, Drawer, Queues},
};
