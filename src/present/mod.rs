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
//! How a program and its display find together, for each kind of program:
//!
//! | the program | takes a buffer by | buffers are exchanged by |
//! |---|---|---|
//! | waits for the display | [`Swapchain::begin_blocking`] with a [`Vsync`] | the same call |
//! | does something else meanwhile | [`Swapchain::begin`], which returns at once | [`Swapchain::flip`] when [`Vsync::is_due`] |
//! | is a task among others | [`Swapchain::begin_async`] | the same call |
//! | is interrupted by the display | [`Drawer::begin`], which never waits with three buffers | [`Display::flip`] in the interrupt |
//!
//! A buffer is whatever the program puts there: memory, or memory and the palette that belongs to it, so that both are exchanged at once.
//!
//! A buffer that comes back holds an older frame. Its [age](Buffer::age) tells which, and [`History`] what has changed since: that alone need be
//! drawn. [`Grain`] makes of it what is to be sent to a display that keeps its picture.
//!
//! Where memory holds only some rows of a screen, [`Bands`] draws it part by part.

mod bands;
mod buffers;
mod history;
mod jobs;
// Where cores load and store a pointer at once, as heapless has it: cores without any atomic access, such as RV32IMC, have no queues.
#[cfg(any(target_has_atomic = "ptr", all(target_arch = "arm", target_os = "none")))]
mod queues;
mod vsync;

#[cfg(any(target_has_atomic = "ptr", all(target_arch = "arm", target_os = "none")))]
pub use self::queues::{Display, Drawer, Queues};
pub use self::{
    bands::{for_each_band, for_each_band_async, Bands},
    buffers::{Buffer, Swapchain},
    history::History,
    jobs::{Grain, Jobs},
    vsync::{Pulse, Vsync},
};
