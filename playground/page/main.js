// The page around the player, which is WebAssembly without bindgen: numbers go in, and pictures are read from its memory.
"use strict";

/** What is chosen, in the order of the player's functions. Each is the id of a select element, too. */
const KINDS = ["scene", "depth", "colors", "dither", "buffers", "band", "time"];
/** What a page shows unless it is told, where that is not the first name. */
const DEFAULTS = { scene: "cube", depth: "16", buffers: "two", time: "14" };
/** What the player's facts are called, in the order of their numbers. */
const FACTS = [
  "refreshes", "frames", "shown", "waited", "painted", "ram-frames", "ram-depths", "ram-tables", "ram-dither", "ram-palette",
];
/** Milliseconds of a refresh. */
const REFRESH = 1000 / 60;

const element = (id) => document.getElementById(id);
const context = element("screen").getContext("2d", { willReadFrequently: true });

/** The functions and the memory of the player. */
let player;
let isPlaying = false;
/** When the last refresh was, in the time of the browser. */
let lastRefresh = 0;

/** The bytes of the player. Where files cannot be fetched, as from a folder, a script has them in letters. */
async function bytes() {
  try {
    if (location.protocol !== "file:") {
      const response = await fetch("playground.wasm");
      if (response.ok) return await response.arrayBuffer();
    }
  } catch {
    // The script is there in any case.
  }
  await new Promise((resolve, reject) => {
    const script = document.createElement("script");
    [script.onload, script.onerror, script.src] = [resolve, reject, "wasm.js"];
    document.head.append(script);
  });
  return Uint8Array.from(atob(WASM), (letter) => letter.charCodeAt(0));
}

/** What the player calls a choice; nothing if there is none. */
function nameOf(kind, number) {
  const at = player.name_at(kind, number + 1);
  return new TextDecoder().decode(new Uint8Array(player.memory.buffer, at, player.name_len(kind, number + 1)));
}

/** What the page calls it. */
function labelOf(kind, name) {
  if (kind === "time") return `${name} ms a frame`;
  if (kind === "band") return name === "whole" ? "whole screen" : `a band of ${name}`;
  if (kind === "colors" && name === "own") return "scene's own";
  if (kind === "buffers") return { one: "one", "two-at-once": "two, at once", two: "two", three: "three" }[name];
  return name.replace("-", kind === "dither" && name.startsWith("F") ? "–" : " ");
}

/** Fills the select elements with all names that there are. */
function fill() {
  KINDS.forEach((id, kind) => {
    for (let number = 0, name; (name = nameOf(kind, number)) !== ""; number += 1) {
      const option = new Option(labelOf(id, name), name);
      option.defaultSelected = name === DEFAULTS[id];
      element(id).add(option);
    }
  });
}

const numbers = () => KINDS.map((id) => element(id).selectedIndex);

/** Only palettes that there are at this depth can be chosen; from 16 bits on there is none, and from 24 on nothing to dither. */
function allow() {
  const colors = element("colors");
  const exists = (index) => {
    const wanted = numbers();
    wanted[KINDS.indexOf("colors")] = index;
    return player.exists(...wanted) !== 0;
  };
  [...colors.options].forEach((option, index) => { option.disabled = !exists(index); });
  if (colors.selectedOptions[0].disabled) {
    colors.selectedIndex = [...colors.options].findIndex((option) => !option.disabled);
  }
  const depth = Number(element("depth").value);
  colors.disabled = depth > 8;
  element("dither").disabled = depth > 16;
}

/** What links say of the choice. */
const fragment = () => KINDS.map((id) => `${id}=${element(id).value}`).join("&");

/** Begins anew with what is chosen. */
function begin() {
  allow();
  player.choose(...numbers());
  [context.canvas.width, context.canvas.height] = [player.width(), player.height()];
  const said = ["scene", "depth"].map((id) => element(id).selectedOptions[0].text);
  context.canvas.setAttribute("aria-label", `What the display shows: ${said[0]}, bits per pixel: ${said[1]}`);
  const { file, text } = SOURCES[element("scene").value];
  if (element("source-name").textContent !== file) {
    [element("source-name").textContent, element("source").textContent] = [file, text];
    element("source").parentElement.scrollTop = 0;
  }
  element("frames-name").textContent = element("band").selectedIndex === 0 ? "RAM: frames" : "RAM: bands";
}

/** The display is refreshed, and what was seen is shown. */
function refresh() {
  if (player.refresh() === 0) throw new Error("the player has failed");
  const [width, height] = [player.width(), player.height()];
  const seen = new Uint8ClampedArray(player.memory.buffer, player.seen(), 4 * width * height);
  context.putImageData(new ImageData(seen, width, height), 0, 0);
}

const fact = (name) => player.fact(FACTS.indexOf(name));
const bytesText = (count) => (count === 0 ? "–" : `${count.toLocaleString("en")} bytes`);
const hex = (number) => (number >>> 0).toString(16).padStart(8, "0");

/** The effect of each byte on a CRC-32. */
const TABLE = Uint32Array.from({ length: 256 }, (_, byte) => {
  for (let bit = 0; bit < 8; bit += 1) byte = (byte >>> 1) ^ (byte & 1 ? 0xedb88320 : 0);
  return byte;
});

/** The checksum of what the canvas shows. */
function pictureCrc() {
  const { data } = context.getImageData(0, 0, context.canvas.width, context.canvas.height);
  let crc = -1;
  for (const byte of data) crc = (crc >>> 8) ^ TABLE[(crc ^ byte) & 255];
  return hex(~crc);
}

/** Milliseconds for a frame: of as many as take some, as clocks of browsers are coarse. */
function drawingTime() {
  const start = performance.now();
  let [count, time] = [0, 0];
  while (time < 8 && count < 200) {
    player.draw();
    count += 1;
    time = performance.now() - start;
  }
  return time / count;
}

/** Writes down what it costs. Measuring takes longer than a refresh, so that is done now and then. */
function tell(measures) {
  const painted = fact("painted");
  const times = painted / (player.width() * player.height());
  element("painted").textContent = `${painted.toLocaleString("en")}, ${times.toFixed(2)} screens`;
  const parts = FACTS.filter((name) => name.startsWith("ram-"));
  for (const name of parts) element(name).textContent = bytesText(fact(name));
  element("ram").textContent = bytesText(parts.reduce((sum, name) => sum + fact(name), 0));
  const dropped = Math.max(0, fact("frames") - fact("shown") - 1);
  element("frames").textContent = `${fact("frames")}, ${dropped}`;
  element("waited").textContent = `${((fact("waited") * REFRESH) / 1000).toFixed(0)} ms`;
  if (measures) {
    element("drawing").textContent = `${drawingTime().toFixed(3)} ms`;
    element("memory-crc").textContent = hex(player.shown_crc32());
    element("picture-crc").textContent = pictureCrc();
  }
  // It is read aloud when it changes, so it does not count while it plays.
  const state = isPlaying ? "playing" : `stopped after ${fact("refreshes")} refreshes of the display`;
  if (element("state").textContent !== state) element("state").textContent = state;
  element("link").href = `#${fragment()}&refresh=${fact("refreshes")}`;
}

function play(now) {
  if (!isPlaying) return;
  requestAnimationFrame(play);
  // A screen may be faster than the display that is simulated; half a millisecond late is in time.
  if (now - lastRefresh < REFRESH - 0.5) return;
  lastRefresh = now;
  refresh();
  const refreshes = fact("refreshes");
  if (refreshes % 15 === 1) tell(refreshes % 60 === 1);
}

function setPlaying(wanted) {
  const wasPlaying = isPlaying;
  isPlaying = wanted;
  element("play").textContent = wanted ? "Stop" : "Play";
  if (wanted && !wasPlaying) requestAnimationFrame(play);
  tell(true);
}

/** Chooses what a link says. One with a number of refreshes is played that far, and stops. */
function open(link) {
  const wanted = new URLSearchParams(link);
  for (const id of KINDS) {
    const option = [...element(id).options].find(({ value }) => value === (wanted.get(id) ?? DEFAULTS[id]));
    element(id).selectedIndex = option ? option.index : 0;
  }
  begin();
  const refreshes = Math.min(Number(wanted.get("refresh")) || 0, 10_000);
  isPlaying = isPlaying && refreshes === 0;
  for (let count = 0; count < Math.max(refreshes, 1); count += 1) refresh();
  return refreshes;
}

/** What the link in the address says. */
function openAddress() {
  setPlaying(open(location.hash.slice(1)) === 0 && !matchMedia("(prefers-reduced-motion: reduce)").matches);
}

async function start() {
  const { instance } = await WebAssembly.instantiate(await bytes());
  player = instance.exports;
  fill();
  element("controls").addEventListener("change", () => {
    begin();
    refresh();
    history.replaceState(null, "", `#${fragment()}`);
    tell(true);
  });
  element("controls").addEventListener("submit", (event) => event.preventDefault());
  element("play").addEventListener("click", () => setPlaying(!isPlaying));
  element("step").addEventListener("click", () => {
    refresh();
    setPlaying(false);
  });
  addEventListener("hashchange", openAddress);
  openAddress();
  // For those who test the page.
  window.playground = { open, fragment, pictureCrc, memoryCrc: () => hex(player.shown_crc32()), fact, player };
}

start().catch((error) => { element("state").textContent = `The playground does not run here: ${error.message}`; });
