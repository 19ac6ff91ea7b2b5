import { defineConfig } from 'vitest/config';

export default defineConfig({
    test: {
        environment: 'happy-dom',
        include: ['tests/**/*.test.ts'],
        css: true,
        // A document for each file took 100 s instead of 11; the tests clean up after themselves.
        pool: 'threads',
        isolate: false,
    },
});
