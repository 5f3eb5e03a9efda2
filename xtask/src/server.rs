//! A server of the files of one folder, for pages on this computer.

use std::fs;
use std::io::{BufRead, BufReader, Write};
use std::net::{TcpListener, TcpStream};
use std::path::{Path, PathBuf};
use std::thread;

use anyhow::{Context, Result};

/// Serves the folder on a port of this computer, the first free one for 0, as long as this program runs. Returns the address of the folder.
pub fn serve(folder: &Path, port: u16) -> Result<String> {
    let listener = TcpListener::bind(("127.0.0.1", port)).context("opening a port")?;
    let (address, folder) = (listener.local_addr()?, folder.to_owned());
    thread::spawn(move || {
        for stream in listener.incoming().flatten() {
            let folder = folder.clone();
            // Who hangs up is not answered.
            thread::spawn(move || _ = answer(stream, &folder));
        }
    });
    Ok(format!("http://{address}/"))
}

/// Answers one request and hangs up.
fn answer(mut stream: TcpStream, folder: &Path) -> Result<()> {
    let mut lines = BufReader::new(stream.try_clone()?).lines();
    let request = lines.next().context("no request")??;
    // The rest of the head says nothing of interest, but is to be read.
    for line in lines {
        if line?.is_empty() {
            break;
        }
    }
    let found = file(&request, folder).and_then(|path| Some((kind(&path), fs::read(path).ok()?)));
    let (status, (kind, body)) = match found {
        Some(found) => ("200 OK", found),
        None => ("404 Not Found", ("text/plain", b"not here\n".to_vec())),
    };
    let length = body.len();
    write!(
        stream,
        "HTTP/1.1 {status}\r\nContent-Type: {kind}\r\nContent-Length: {length}\r\nCache-Control: no-store\r\nConnection: close\r\n\r\n"
    )?;
    Ok(stream.write_all(&body)?)
}

/// The file that a request is for: one of the folder itself.
fn file(request: &str, folder: &Path) -> Option<PathBuf> {
    let path = request.strip_prefix("GET /")?.split(' ').next()?;
    let name = path.split(['?', '#']).next().filter(|name| !name.is_empty()).unwrap_or("index.html");
    let is_plain = name.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'.' || b == b'-') && !name.starts_with('.');
    is_plain.then(|| folder.join(name))
}

fn kind(path: &Path) -> &'static str {
    match path.extension().and_then(|end| end.to_str()) {
        Some("html") => "text/html; charset=utf-8",
        Some("css") => "text/css; charset=utf-8",
        Some("js") => "text/javascript; charset=utf-8",
        Some("wasm") => "application/wasm",
        _ => "application/octet-stream",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_files_of_the_folder_are_served() {
        let folder = Path::new("folder");
        for (request, expected) in [
            ("GET / HTTP/1.1", Some("folder/index.html")),
            ("GET /main.js?v=1 HTTP/1.1", Some("folder/main.js")),
            ("GET /../secret HTTP/1.1", None),
            ("GET /.git HTTP/1.1", None),
            ("GET /a/b.js HTTP/1.1", None),
            ("POST / HTTP/1.1", None),
        ] {
            assert_eq!(file(request, folder).as_deref(), expected.map(Path::new), "{request}");
        }
    }
}
