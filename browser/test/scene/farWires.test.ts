// Lines from afar are few drawings.
import { expect, test } from 'vitest'
import { bundles, wireOutlines } from '../../src/scene/farWires'

const at = { x: 0, y: 0 }

// R-G07
test('the lines of many variables are drawn in bundles, none twice and none left out', () => {
  const all = Array.from({ length: 150 }, (_, k) => k)
  expect(bundles(all).map((bundle) => bundle.length)).toEqual([64, 64, 22])
  expect(bundles(all).flat()).toEqual(all)
  expect(bundles([])).toEqual([])
})

// R-C09, R-C25
test('lines that look alike are one outline; those without a way or a variable are left out', () => {
  const wires = [
    { svar: 'A', d: 'M0 0H5' },
    { svar: 'B', d: 'M1 1H6' },
    { svar: 'C', d: 'M2 2H7' },
    { svar: 'HIDDEN', d: '' },
    { svar: 'GONE', d: 'M9 9H9' },
  ]
  const loci = { A: { ...at, line: 'live' as const }, B: at, C: { ...at, line: 'live' as const }, HIDDEN: at }
  expect(wireOutlines(wires, loci)).toEqual([
    { look: 'live', d: 'M0 0H5M2 2H7' },
    { look: 'idle', d: 'M1 1H6' },
  ])
})
