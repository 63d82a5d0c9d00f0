// A real Chromium, and what the tests ask of a page in it.
import { existsSync } from "node:fs";
import puppeteer from "puppeteer-core";

const CHROMIUM = ["/usr/bin/chromium", "/usr/bin/chromium-browser",
                  "/usr/bin/google-chrome"];

// A busy machine may take minutes over what takes a second.
const BUSY = 180000;  // [ms]

/** The browser; null where there is none. */
export async function browser() {
  const executablePath = CHROMIUM.find(existsSync);
  if (!executablePath) return null;
  return puppeteer.launch({ executablePath, headless: true, args: [
    "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
    "--force-device-scale-factor=1"] });
}

/** A page of a German reader that keeps what it said and what it asked the network for. */
export async function open(chromium, url, size = { width: 1280, height: 900 }) {
  const page = await chromium.newPage();
  page.setDefaultTimeout(BUSY);
  const session = await page.createCDPSession();
  await session.send("Emulation.setLocaleOverride", { locale: "de-DE" });
  await session.send("Performance.enable");
  const said = [], requests = [];
  page.on("console", (message) => said.push(message.text()));
  page.on("pageerror", (error) => said.push(String(error)));
  page.on("request", (request) => {
    if (request.url() !== url && !request.url().startsWith("data:")) {
      requests.push(request.url());
    }
  });
  await page.setViewport(size);
  await page.goto(url, { waitUntil: "load" });
  await page.waitForSelector("html[data-built]");
  return { page, session, said, requests };
}
