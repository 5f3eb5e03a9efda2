//! A browser without a window, told what to do by its debugging protocol: messages in JSON, each ended by a byte 0, over two pipes.
//!
//! Protocol: <https://chromedevtools.github.io/devtools-protocol/>.

use std::fs::{self, File};
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{self, Receiver};
use std::thread;
use std::time::{Duration, Instant};

use anyhow::{bail, ensure, Context, Result};
use base64::prelude::{Engine, BASE64_STANDARD};
use serde_json::{json, Value};

/// How long an answer may take.
const PATIENCE: Duration = Duration::from_secs(240);

/// What the browser is called.
const NAMES: [&str; 3] = ["chromium", "chromium-browser", "google-chrome"];

/// A browser that runs. It ends with this value.
pub struct Browser {
    child: Child,
    /// Its profile, and the pipes.
    folder: PathBuf,
    commands: File,
    answers: Receiver<Value>,
    last: u32,
}

/// A page in a browser.
pub struct Page<'a> {
    browser: &'a mut Browser,
    session: String,
}

impl Browser {
    /// Where a browser is installed; `None` if there is none.
    pub fn find() -> Option<PathBuf> {
        let path = std::env::var_os("PATH")?;
        let folders: Vec<_> = std::env::split_paths(&path).collect();
        NAMES.iter().flat_map(|name| folders.iter().map(move |folder| folder.join(name))).find(|path| path.is_file())
    }

    /// Starts the browser in a folder that does not exist yet, which is removed when it ends.
    pub fn start(program: &Path, folder: &Path) -> Result<Self> {
        fs::create_dir_all(folder)?;
        let [commands, answers] = ["commands", "answers"].map(|name| folder.join(name));
        let made = Command::new("mkfifo").args([&commands, &answers]).status().context("starting mkfifo")?;
        ensure!(made.success(), "mkfifo ended with {made}");
        // The browser reads from descriptor 3 and writes to descriptor 4: a shell opens them, and becomes the browser.
        let mut shell = Command::new("sh");
        shell.args(["-c", r#"exec "$0" "$@" 3<"$COMMANDS" 4>"$ANSWERS""#]).arg(program);
        shell.env("COMMANDS", &commands).env("ANSWERS", &answers);
        shell.args(["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--mute-audio"]);
        shell.args(["--disable-background-networking", "--disable-component-update", "--disable-sync"]);
        shell.args(["--disable-extensions", "--force-color-profile=srgb", "--remote-debugging-pipe"]);
        shell.arg(format!("--user-data-dir={}", folder.join("profile").display()));
        let child = shell.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null()).spawn();
        let child = child.context("starting a shell")?;
        // In the order of the shell: each end waits for the other.
        let commands = File::options().write(true).open(&commands)?;
        let mut reader = BufReader::new(File::open(&answers)?);
        let (sender, answers) = mpsc::channel();
        thread::spawn(move || {
            let mut message = Vec::new();
            while reader.read_until(0, &mut message).is_ok_and(|length| length > 0) {
                message.pop();
                let sent = serde_json::from_slice(&message).is_ok_and(|value| sender.send(value).is_ok());
                if !sent {
                    break;
                }
                message.clear();
            }
        });
        Ok(Self { child, folder: folder.to_owned(), commands, answers, last: 0 })
    }

    /// Opens a page.
    pub fn open(&mut self, address: &str) -> Result<Page<'_>> {
        let target = self.call(None, "Target.createTarget", json!({ "url": address }))?;
        let wanted = json!({ "targetId": target["targetId"], "flatten": true });
        let session = self.call(None, "Target.attachToTarget", wanted)?;
        let session = session["sessionId"].as_str().context("a page without a session")?.to_owned();
        Ok(Page { browser: self, session })
    }

    /// Calls a method and waits for what it returns.
    fn call(&mut self, session: Option<&str>, method: &str, params: Value) -> Result<Value> {
        self.last += 1;
        let mut message = json!({ "id": self.last, "method": method });
        message["params"] = params;
        if let Some(session) = session {
            message["sessionId"] = session.into();
        }
        write!(self.commands, "{message}\0").context("the browser has ended")?;
        let end = Instant::now() + PATIENCE;
        loop {
            let rest = end.saturating_duration_since(Instant::now());
            let answer = self.answers.recv_timeout(rest).with_context(|| format!("{method}: no answer"))?;
            // Events have no number.
            if answer["id"] == self.last {
                ensure!(answer["error"].is_null(), "{method}: {}", answer["error"]);
                return Ok(answer["result"].clone());
            }
        }
    }
}

impl Drop for Browser {
    fn drop(&mut self) {
        // It may have ended by itself.
        _ = self.call(None, "Browser.close", json!({}));
        _ = self.child.kill();
        _ = self.child.wait();
        _ = fs::remove_dir_all(&self.folder);
    }
}

impl Page<'_> {
    fn call(&mut self, method: &str, params: Value) -> Result<Value> {
        self.browser.call(Some(&self.session), method, params)
    }

    /// What an expression of JavaScript gives, when it is there.
    pub fn evaluate(&mut self, expression: &str) -> Result<Value> {
        let params = json!({ "expression": expression, "awaitPromise": true, "returnByValue": true });
        let answer = self.call("Runtime.evaluate", params)?;
        if !answer["exceptionDetails"].is_null() {
            bail!("{expression}: {}", answer["exceptionDetails"]);
        }
        Ok(answer["result"]["value"].clone())
    }

    /// Waits until an expression is true.
    pub fn wait_for(&mut self, expression: &str) -> Result<()> {
        let start = Instant::now();
        while self.evaluate(expression)? != true {
            ensure!(start.elapsed() < Duration::from_secs(60), "still not true: {expression}");
            thread::sleep(Duration::from_millis(50));
        }
        Ok(())
    }

    /// Presses a key and lets it go. `code` is the number that it has in pages since the first browsers.
    pub fn press(&mut self, key: &str, code: u32) -> Result<()> {
        let text = if key == " " { " " } else { "" };
        for kind in ["keyDown", "keyUp"] {
            let params = json!({ "type": kind, "key": key, "windowsVirtualKeyCode": code, "text": text });
            self.call("Input.dispatchKeyEvent", params)?;
        }
        Ok(())
    }

    /// Gives the page a width and a height, as a telephone has them or as a desk.
    pub fn resize(&mut self, width: u32, height: u32) -> Result<()> {
        let mobile = width < 600;
        let params = json!({ "width": width, "height": height, "deviceScaleFactor": 1, "mobile": mobile });
        self.call("Emulation.setDeviceMetricsOverride", params)?;
        Ok(())
    }

    /// Writes what is seen of the page as a PNG file, down to its end.
    pub fn photograph(&mut self, path: &Path) -> Result<()> {
        let params = json!({ "format": "png", "captureBeyondViewport": true });
        let answer = self.call("Page.captureScreenshot", params)?;
        let data = answer["data"].as_str().context("no picture")?;
        fs::write(path, BASE64_STANDARD.decode(data)?).with_context(|| path.display().to_string())
    }
}
