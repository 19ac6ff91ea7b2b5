import { describe, expect, it } from 'vitest';

import {
    capitalise,
    formatBytes,
    formatCount,
    formatDistance,
    formatDuration,
    formatName,
    formatPlural,
    formatShare,
    formatSize,
} from '../../src/page/format';

describe('formats', () => {
    it('group digits and count in words', () => {
        expect(formatCount(12345)).toBe('12,345');
        expect(formatPlural(1, 'branch', 'branches')).toBe('1 branch');
        expect(formatPlural(0, 'branch', 'branches')).toBe('0 branches');
        expect(formatPlural(2000, 'model', 'models')).toBe('2,000 models');
    });

    it('keep neighbours of a ranked list apart', () => {
        expect(formatDistance(0.123)).not.toBe(formatDistance(0.124));
        expect(formatDistance(0)).toBe('0.000');
    });

    it('give a box its three lengths in the unit of its file, if it names one', () => {
        const box = { min: [-1, 0, 2], max: [1, 1234.567, 2.0001234] };
        expect(formatSize(box, 'mm')).toBe('2 × 1,235 × 0.0001234 mm');
        expect(formatSize(box, null)).toBe('2 × 1,235 × 0.0001234');
    });

    it('show a dash for what is no number', () => {
        for (const value of [Number.NaN, Number.POSITIVE_INFINITY]) {
            expect(formatDistance(value)).toBe('–');
            expect(formatShare(value)).toBe('–');
        }
    });

    it.each([
        [0, '0 ms'],
        [1.25, '1.3 ms'],
        [84.3, '84 ms'],
        [999, '999 ms'],
        [1234, '1.2 s'],
        [65_432, '65 s'],
    ])('say %d ms as %s', (time, text) => {
        expect(formatDuration(time)).toBe(text);
    });

    it.each([
        [0, '0 B'],
        [999, '999 B'],
        [1000, '1.0 kB'],
        [2_600_000, '2.6 MB'],
        [999_950, '1.0 MB'],
        [60_000_000, '60.0 MB'],
        [3_000_000_000_000, '3000 GB'],
    ])('say %d bytes as %s', (bytes, text) => {
        expect(formatBytes(bytes)).toBe(text);
    });

    it('make words of identifiers', () => {
        expect(formatName('mean_average_precision')).toBe('mean average precision');
        expect(capitalise(formatName('chain-code'))).toBe('Chain code');
        expect(capitalise('')).toBe('');
    });
});
