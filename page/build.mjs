// Makes the bundle that the package ships: one script, one style sheet, one document, and the licences.
import { build } from "esbuild";
import { copyFileSync, readFileSync, writeFileSync } from "node:fs";

const out = process.argv[2] ?? "../executive/web/bundle";
await build({
  entryPoints: ["src/main.tsx"],
  bundle: true,
  minify: true,
  format: "esm",
  target: "es2022",
  legalComments: "none",
  jsx: "automatic",
  jsxImportSource: "preact",
  outfile: `${out}/app.js`,
});
await build({ entryPoints: ["src/app.css"], minify: true, outfile: `${out}/app.css` });
copyFileSync("src/index.html", `${out}/index.html`);
const { dependencies } = JSON.parse(readFileSync("package.json", "utf8"));
const licences = Object.keys(dependencies).sort().map((name) => {
  const folder = `node_modules/${name}`;
  const { version, license } = JSON.parse(readFileSync(`${folder}/package.json`, "utf8"));
  const file = ["LICENSE", "LICENSE.md", "LICENSE.txt"].find((each) => {
    try { return readFileSync(`${folder}/${each}`), true; } catch { return false; }
  });
  // urdf-loader brings no file: its README has the copyright, and Apache-2.0 is our own licence, too.
  const readme = readFileSync(`${folder}/README.md`, "utf8");
  const own = () => `${readme.slice(readme.indexOf("# LICENSE"))}\n\n${readFileSync("../LICENSE", "utf8")}`;
  const text = (file ? readFileSync(`${folder}/${file}`, "utf8") : own()).trim();
  return `${name} ${version} (${license})\n\n${text}\n`;
});
writeFileSync(`${out}/LICENSES.txt`, `The page contains these packages.\n\n${licences.join("\n---\n\n")}`);
