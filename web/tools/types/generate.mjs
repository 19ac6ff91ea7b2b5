// Writes web/src/api/types.ts from server/openapi.yaml; with --check says whether it is as it should be.
import { readFile, writeFile } from 'node:fs/promises';
import openapiTypescript, { astToString } from 'openapi-typescript';

const source = new URL('../../../server/openapi.yaml', import.meta.url);
const target = new URL('../../src/api/types.ts', import.meta.url);

const nodes = await openapiTypescript(source, {
    arrayLength: true,
    rootTypes: true,
    rootTypesKeepCasing: true,
    rootTypesNoSchemaPrefix: true,
    silent: true,
});
const text = `// Written by \`npm run api\` from server/openapi.yaml: change that one.\n\n${astToString(nodes)}`;

if (process.argv.includes('--check')) {
    if ((await readFile(target, 'utf8')) !== text) {
        console.error(
            'web/src/api/types.ts is not what server/openapi.yaml says: npm run api in web/',
        );
        process.exit(1);
    }
} else {
    await writeFile(target, text);
}
