// Simulates the mechanisms of entries.json: a page and a picture of each, and an index of them.
//   node make_gallery.mjs ALEMBERT MECHANISMS_FOLDER ENTRIES OUT [NAME...]
// With names, only these. Motions that stop early are shown as far as they go, with the reason.
import { execFileSync, spawnSync } from "node:child_process";
import { existsSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { basename } from "node:path";
import { drawn, openPage, startBrowser } from "./browser.mjs";

const [alembert, mechanisms, entriesFile, out, ...wanted] = process.argv.slice(2);
const kWidth = 480;
const kHeight = 300;
const kDuration = "10";

const escaped = (text) => text.replace(/&/g, "&amp;").replace(/</g, "&lt;").replace(/"/g, "&quot;");

/// Entries, and after them descriptions of the paper's mechanisms that no entry names.
function allEntries() {
  const entries = JSON.parse(readFileSync(entriesFile, "utf8"));
  for (const entry of entries) entry.name ??= basename(entry.file, ".yaml");
  const named = new Set(entries.flatMap((entry) => [entry.file, ...(entry.scene ?? [])]));
  for (const file of readdirSync(`${mechanisms}/paper`).sort()) {
    const name = basename(file, ".yaml");
    if (file.endsWith(".yaml") && !named.has(`paper/${file}`)) entries.push({ file: `paper/${file}`, name, title: name.replaceAll("_", " ") });
  }
  return entries;
}

function simulate(entry) {
  const args = ["simulate", `${mechanisms}/${entry.file}`, "--duration", entry.duration ?? kDuration, "--html", `${out}/${entry.name}.html`];
  if (entry.scene) args.push("--scene", entry.scene.map((file) => `${mechanisms}/${file}`).join(","));
  const { status, stderr } = spawnSync(alembert, [...args, ...(entry.options ?? [])], { encoding: "utf8" });
  if (status === 0) return;
  if (status !== 1 || !existsSync(`${out}/${entry.name}.html`)) throw new Error(`${entry.name}: ${stderr}`);
  entry.stopped = stderr.split("\n")[0].replace(/^.*?error: /, "");
  console.log(`${entry.name} stops early: ${entry.stopped}`);
}

async function photograph(browser, entry) {
  const { page, wrong } = await openPage(browser, `${out}/${entry.name}.html`, { width: kWidth, height: kHeight });
  await page.addStyleTag({ content: "#heading, #view, #plots, #playback { display: none !important; } body { grid-template: 1fr / 1fr !important; }" });
  await drawn(page);
  if (entry.trails) await page.evaluate(() => document.getElementById("trails").click());
  await page.evaluate((time) => {
    window.viewer.seek(time ?? 0.37 * window.viewer.duration);
    window.viewer.showAll();
  }, entry.time);
  await drawn(page);
  await page.screenshot({ path: `${out}/${entry.name}.png` });
  if (wrong.length > 0) throw new Error(`${entry.name}: ${wrong.join("; ")}`);
  await page.close();
}

function writeIndex(entries) {
  let body = "";
  let figure = "";
  for (const entry of entries) {
    figure = entry.figure ?? figure;
    const stopped = entry.stopped ? `<small>Stops early: ${escaped(entry.stopped)}</small>` : "";
    body += `<a href="${entry.name}.html"><img src="${entry.name}.png" width="${kWidth}" height="${kHeight}" alt="">
<small>${escaped(figure)}</small>${escaped(entry.title)}${stopped}</a>\n`;
  }
  writeFileSync(`${out}/index.html`, `<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1"><title>alembert: gallery</title>
<style>
:root { color-scheme: light dark; font: 15px/1.5 system-ui, sans-serif; }
body { background: light-dark(#eef0f3, #14171c); color: light-dark(#1d2430, #e8ecf2); margin: 0 auto; max-width: 1500px; padding: 24px; }
h1 { font-size: 24px; margin: 0; }
p { margin: 4px 0 20px; opacity: 0.75; }
div { display: grid; gap: 18px; grid-template-columns: repeat(auto-fill, minmax(300px, 1fr)); }
a { background: light-dark(#ffffff, #1b1f26); border-radius: 10px; color: inherit; display: block; overflow: hidden; padding-bottom: 10px; text-decoration: none; }
a { font-weight: 550; padding-left: 14px; }
a:hover { outline: 2px solid #2f6fb0; }
img { aspect-ratio: ${kWidth} / ${kHeight}; display: block; height: auto; margin: 0 0 8px -14px; width: calc(100% + 14px); max-width: none; }
small { display: block; font-weight: 400; opacity: 0.7; padding-right: 14px; }
</style></head><body>
<h1>Mechanisms in motion</h1><p>Each picture leads to a page: pull the mechanism, drag beside it to turn, space to pause.</p>
<div>
${body}</div>
</body></html>
`);
}

mkdirSync(out, { recursive: true });
const entries = allEntries().filter((entry) => wanted.length === 0 || wanted.includes(entry.name));
console.log(execFileSync(alembert, ["--version"], { encoding: "utf8" }).trim());
const browser = await startBrowser();
try {
  for (const entry of entries) {
    simulate(entry);
    await photograph(browser, entry);
    console.log(entry.name);
  }
} finally {
  await browser.close();
}
if (wanted.length === 0) writeIndex(entries);
