import { defineConfig } from 'vitest/config';

export default defineConfig({
    test: {
        environment: 'happy-dom',
        include: ['tests/**/*.test.ts'],
        css: true,
        // Of a busy machine; the checks that wait have limits of their own.
        testTimeout: 240_000,
        hookTimeout: 240_000,
        // A document for each file took 100 s instead of 11; the tests clean up after themselves.
        pool: 'threads',
        isolate: false,
    },
});
