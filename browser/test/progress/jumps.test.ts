import { expect, test } from 'vitest'
import type { JumpView } from '../../src/api.gen'
import { jumpLines } from '../../src/progress/jumps'

const jump = (given: Partial<JumpView> = {}): JumpView => ({
  subsystem: 'flow0',
  task: 'puma',
  variable: 'TAU_REF[1]',
  unit: 'N m',
  jump: 3.4386,
  limit: 18.64,
  at_s: 21.184,
  count: 19,
  ...given,
})

test('a run without a step beyond its limit says how smooth it was, by the largest share', () => {
  const [line, ...more] = jumpLines([jump({ variable: 'Q_REF[0]', unit: 'rad', jump: 0.0003, limit: 0.01 }), jump()])
  expect(more).toEqual([])
  expect(line).toEqual({
    text: 'Smooth: the largest step at a switch was 19 % of what is allowed (TAU_REF[1]).',
    hint: '3.44 N m at 21.2 s; one cycle may change it by 18.6 N m',
    isNote: false,
  })
})

test('what was blended is said with its numbers, and how often', () => {
  const [line] = jumpLines([jump({ jump: 40, blended: 3, cycles: 6 })])
  expect(line?.text).toBe(
    'TAU_REF[1] stepped by 40 N m at 21.2 s, more than the 18.6 N m of one cycle. It was blended over 6 cycles. At 3 switches steps were blended.',
  )
  expect(line?.isNote).toBe(true)
})

test('what was refused says that the drive held', () => {
  const [line] = jumpLines([jump({ jump: 2000, refused: 1 })])
  expect(line?.text).toBe(
    'TAU_REF[1] would have stepped by 2000 N m at 21.2 s, too far to blend at 18.6 N m in one cycle: the drive held.',
  )
})

test('of a variable whose task says nothing the step alone is said, and none where it never stepped', () => {
  expect(
    jumpLines([jump({ limit: 0, jump: 2, unit: '-', variable: 'GRIP[0]', task: 'hand' })]).map((one) => one.text),
  ).toEqual(['GRIP[0] stepped by 2 at most; hand does not say how far it may.'])
  expect(jumpLines([jump({ limit: 0, jump: 0 })])).toEqual([])
  expect(jumpLines([])).toEqual([])
})
