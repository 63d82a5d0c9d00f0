// Validates a .glb by Khronos' gltf-validator and looks for what it must hold.
//
//     node glb.mjs FILE.glb PARTS
//
// Exit code 1 if it has an error or warning, or not so many meshes.
import { readFileSync } from "node:fs";
import validator from "gltf-validator";

const [file, parts] = process.argv.slice(2);
const bytes = new Uint8Array(readFileSync(file));
const report = await validator.validateBytes(bytes, { maxIssues: 20 });
const { numErrors, numWarnings, messages } = report.issues;
for (const message of messages) {
  console.log(`${message.severity} ${message.code} ${message.pointer}: ` +
              message.message);
}
const length = new DataView(bytes.buffer).getUint32(12, true);
const json = JSON.parse(new TextDecoder().decode(bytes.subarray(20, 20 + length)));
const meshes = json.meshes.length;
const { animationCount, totalTriangleCount } = report.info;
console.log(`${bytes.length} bytes, ${meshes} meshes, ${animationCount} ` +
            `animations, ${totalTriangleCount} triangles`);
process.exit(numErrors + numWarnings > 0 || meshes !== Number(parts) ? 1 : 0);
