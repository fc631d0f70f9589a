// Finding a task to place, and what would connect.
import { describe, expect, test } from 'vitest'
import type { DocumentView, TaskView } from '../../src/api.gen'
import { examples } from '../../src/files/examples'
import { find, joins } from '../../src/library/find'
import { plain } from '../../src/texts/say'

const task = (name: string, description: string, reads: string[], writes: string[]): TaskView => ({
  name,
  module: name,
  library: 'generic',
  order: 0,
  description,
  width: 136,
  height: 100,
  pins: [
    ...reads.map((svar, k) => ({ name: `I${k}`, svar, kind: 'INVAR' as const, y: 55 })),
    ...writes.map((svar, k) => ({ name: `O${k}`, svar, kind: 'OUTVAR' as const, y: 55 })),
  ],
})
const TASKS = {
  pd: task('pd', 'A controller.', ['Q_MEZ', 'Q_REF'], ['TAU']),
  gravcomp: task('gravcomp', 'Weight of the arm.', ['Q_MEZ'], ['TAU_G']),
  pid: task('pid', 'A controller with memory.', ['Q_MEZ'], ['TAU']),
  lowpass: task('lowpass', 'Takes a controller’s noise away.', ['X'], ['Y']),
}
const DOC: DocumentView = {
  name: 'd',
  order: 1,
  loci: { Q_MEZ: { x: 0, y: 0, writers: ['puma'] }, Q_REF: { x: 0, y: 0, readers: ['pd'] } },
  greyed: { pd: [{ text: plain('on the canvas') }] },
}
const names = (words: string): string[] => find(words, TASKS, DOC).map((one) => one.task.name)

describe('finding', () => {
  // R-C03
  test('what may not be placed comes last, with its reason', () => {
    // R-C07, R-X01
    expect(names('')).toEqual(['gravcomp', 'lowpass', 'pid', 'pd'])
    expect(find('pd', TASKS, DOC)[0]!.why).toBe('on the canvas')
  })

  test('a name that begins so comes before one that only holds it, a variable, and a description', () => {
    expect(names('p')).toEqual(['pid', 'gravcomp', 'lowpass', 'pd'])
    expect(names('tau_g')).toEqual(['gravcomp'])
    expect(names('controller')).toEqual(['lowpass', 'pid', 'pd'])
  })

  test('nothing is found where nothing is meant', () => {
    expect(names('zebra')).toEqual([])
  })

  test('what would connect is what somebody writes already', () => {
    // R-C09
    expect(joins(TASKS.pd, DOC)).toEqual({ reads: ['Q_MEZ'], from: ['puma'], writes: ['TAU'] })
    expect(joins(TASKS.lowpass, undefined)).toEqual({ reads: [], from: [], writes: ['Y'] })
  })
})

describe('the examples of the first page', () => {
  const file = (name: string, tasks: number) => ({ name, base: 'puma', path: `/p/${name}.conf`, tasks })
  const files = Object.fromEntries(
    [file('aaa', 2), file('cmoveC', 9), file('jmoveC', 7), file('zzz', 12)].map((one) => [one.path, one]),
  )

  test('are those that show most, and then the largest', () => {
    expect(examples(files).map((one) => one.file.name)).toEqual(['jmoveC', 'cmoveC', 'zzz'])
  })

  test('say what they do where that is known', () => {
    expect(examples(files).map((one) => one.about)).toEqual(['canvas.example.jmove', 'canvas.example.cmove', undefined])
  })
})
