// A headless Chromium for tests and pictures. Out: pages that report whatever goes wrong in them.
import puppeteer from "puppeteer-core";

const kPatience = 240000;  // ms; the picture is drawn in software, perhaps beside other tests

export async function startBrowser() {
  const executablePath = process.env.CHROMIUM;
  if (!executablePath) throw new Error("CHROMIUM does not say where Chromium is");
  return puppeteer.launch({
    executablePath,
    headless: true,
    protocolTimeout: kPatience,
    timeout: kPatience,
    // Containers have no sandbox for root; the pages are our own.
    args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-dev-shm-usage"],
  });
}

/// Opens a file. `wrong` collects errors and warnings of the page, and requests that leave the file.
export async function openPage(browser, path, { scheme = "light", width = 1280, height = 760, scale = 1 } = {}) {
  const page = await browser.newPage();
  const wrong = [];
  page.setDefaultTimeout(kPatience);
  page.on("pageerror", (error) => wrong.push(`error: ${error.message}`));
  page.on("console", (message) => {
    // Reading back the picture is slow on purpose here.
    if (/GPU stall due to ReadPixels/.test(message.text())) return;
    if (["error", "warn", "assert"].includes(message.type())) wrong.push(`console: ${message.text()}`);
  });
  page.on("request", (request) => {
    if (!/^(data|blob):/.test(request.url()) && request.url() !== `file://${path}#paused`)
      wrong.push(`request: ${request.url()}`);
  });
  await page.setViewport({ width, height, deviceScaleFactor: scale });
  await page.emulateMediaFeatures([{ name: "prefers-color-scheme", value: scheme }]);
  await page.goto(`file://${path}#paused`, { timeout: kPatience });
  return { page, wrong };
}

/// Waits until what was asked for has been drawn.
export async function drawn(page) {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
}
