import { describe, expect, it } from 'vitest';

import { ApiError, isAbort, problemFrom, unreachable } from '../../src/api/problem';

describe('problemFrom', () => {
    it('keeps code, detail and request id of a problem document', () => {
        const problem = problemFrom(422, {
            title: 'The model cannot be read',
            status: 422,
            detail: 'line 3: expected 3 numbers, found 2',
            code: 'off_truncated',
            request_id: 'r-1',
        });
        const error = new ApiError(problem);
        expect(error.code).toBe('off_truncated');
        expect(error.message).toBe('line 3: expected 3 numbers, found 2');
        expect(error.requestId).toBe('r-1');
        expect(error.status).toBe(422);
    });

    it.each([undefined, null, 'gateway error', 7, [], { code: 12, detail: null, title: {} }])(
        'makes a problem of any other body: %j',
        (body) => {
            const error = new ApiError(problemFrom(502, body, 'from-header'));
            expect(error.code).toBe('unexpected_answer');
            expect(error.message).toContain('502');
            expect(error.requestId).toBe('from-header');
        },
    );
});

describe('isAbort', () => {
    it('tells an abort from a failure', () => {
        expect(isAbort(new DOMException('stopped', 'AbortError'))).toBe(true);
        expect(isAbort(unreachable())).toBe(false);
        expect(isAbort(new Error('AbortError'))).toBe(false);
    });
});
