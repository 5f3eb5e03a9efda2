//! Frames on their way to a display. What can happen to buffers is explored beside them, in `src/present`.

mod bands;
mod cores;
mod queues;
