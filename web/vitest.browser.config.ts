import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vitest/config';

const inside = (path: string) => fileURLToPath(new URL(path, import.meta.url));

/** The tests lie outside web/, so that their imports have to be led to web/node_modules. */
export default defineConfig({
    root: inside('../tests/browser'),
    resolve: {
        alias: {
            'gltf-validator': inside('node_modules/gltf-validator/index.js'),
            'playwright-core': inside('node_modules/playwright-core/index.mjs'),
            vitest: inside('node_modules/vitest/dist/index.js'),
        },
    },
    server: { fs: { allow: [inside('..')] } },
    test: {
        environment: 'node',
        include: ['**/*.test.ts'],
        // Longer than the longest wait inside: that one says what it waited for.
        testTimeout: 1_200_000,
        hookTimeout: 900_000,
        fileParallelism: false,
    },
});
