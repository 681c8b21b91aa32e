// node bundle.mjs OUTPUT: the page of reports as one HTML file, its data left open.
import { readFileSync, writeFileSync } from "node:fs";
import { build } from "esbuild";

const libraries = ["three", "uplot"];
const read = (path) => readFileSync(new URL(path, import.meta.url), "utf8");

async function script() {
  const result = await build({
    entryPoints: [new URL("src/main.js", import.meta.url).pathname],
    bundle: true,
    minify: true,
    write: false,
    format: "iife",
    target: "es2020",
    charset: "ascii",
    legalComments: "none",
    logLevel: "warning",
  });
  return result.outputFiles[0].text;
}

function licences() {
  const escaped = (text) => text.replace(/&/g, "&amp;").replace(/</g, "&lt;");
  return libraries
    .map((name) => {
      const { version } = JSON.parse(read(`node_modules/${name}/package.json`));
      return `${name} ${version}\n\n${escaped(read(`node_modules/${name}/LICENSE`).trim())}`;
    })
    .join("\n\n\n");
}

const parts = {
  STYLE: read("node_modules/uplot/dist/uPlot.min.css") + read("src/style.css"),
  SCRIPT: await script(),
  LICENCES: licences(),
};
const page = read("src/page.html").replace(
  /<!--([A-Z]+)-->|\/\*([A-Z]+)\*\//g,
  (mark, html, code) => parts[html ?? code] ?? mark,
);
writeFileSync(process.argv[2], page);
