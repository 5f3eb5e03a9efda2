//! How the programs of this project end: [`finish`].

use std::{
    error::Error,
    io::{self, Write},
    process::ExitCode,
};

/// Ends a program: prints what it has to say, or its error in one line behind its name.
///
/// A reader that has heard enough, such as `head`, is no error. Everything else that keeps the text from being written is one.
/// ```
/// use embedded_raster_simulator::finish;
/// use std::process::ExitCode;
/// assert_eq!(finish("hello", Ok("hello.png: 64 x 48\n".into())), ExitCode::SUCCESS);
/// assert_eq!(finish("hello", Err("hello.png: is a directory".into())), ExitCode::FAILURE);
/// ```
pub fn finish(program: &str, outcome: Result<String, Box<dyn Error>>) -> ExitCode {
    let (code, text) = ending(program, outcome, io::stdout());
    // There is nobody left to tell if this fails.
    _ = io::stderr().write_all(text.as_bytes());
    code
}

/// The exit code, and what goes to standard error.
fn ending(program: &str, outcome: Result<String, Box<dyn Error>>, mut out: impl Write) -> (ExitCode, String) {
    let printed = outcome.and_then(|text| match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(format!("standard output: {error}").into()),
        _ => Ok(()),
    });
    match printed {
        Ok(()) => (ExitCode::SUCCESS, String::new()),
        Err(error) => (ExitCode::FAILURE, format!("{program}: {error}\n")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Fails in one way.
    struct Broken(io::ErrorKind);

    impl Write for Broken {
        fn write(&mut self, _: &[u8]) -> io::Result<usize> {
            Err(self.0.into())
        }

        fn flush(&mut self) -> io::Result<()> {
            Err(self.0.into())
        }
    }

    #[test]
    fn errors_are_one_line() {
        let mut out = vec![];
        assert_eq!(ending("x", Ok("done\n".into()), &mut out), (ExitCode::SUCCESS, String::new()), "no error");
        assert_eq!(out, b"done\n", "what it has to say");
        let failed = ending("x", Err("a.png: is a directory".into()), &mut out);
        assert_eq!(failed, (ExitCode::FAILURE, "x: a.png: is a directory\n".into()), "behind the name");
        assert_eq!(out, b"done\n", "and nothing else");
    }

    #[test]
    fn a_reader_may_stop() {
        let to = |kind| ending("x", Ok("done\n".into()), Broken(kind));
        assert_eq!(to(io::ErrorKind::BrokenPipe), (ExitCode::SUCCESS, String::new()), "as `head` does");
        let full = "x: standard output: no storage space\n";
        assert_eq!(to(io::ErrorKind::StorageFull), (ExitCode::FAILURE, full.into()), "a disk that is full is an error");
    }
}
