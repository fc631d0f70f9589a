// R-X06: the stop explained: when it shows itself, what it is called, what can be done, which plots say most.
import { beforeAll, beforeEach, describe, expect, it } from 'vitest'
import type { ApplicationView, CourseView, RuntimeView, RunView, StopView } from '../../src/api.gen'
import { look } from '../../src/state/look.svelte'
import { isAllSimulated } from '../../src/progress/displaced'
import { standstills, shownStop } from '../../src/progress/shownStop.svelte'
import { accountOf, choicesOf, inShort, titleOf } from '../../src/progress/stopText'
import { stopVariables } from '../../src/progress/stopVariables'
import { plain } from '../../src/texts/say'
import { fetchTranslation } from '../../src/texts/translations.svelte'

beforeAll(() => fetchTranslation('es'))

const stop = (more: Partial<StopView> = {}): StopView => ({
  text: plain('cycle: no solution'),
  kind: 'error',
  at_s: 12,
  subsystem: 'flow0',
  task: 'invkin',
  ...more,
})
let number = 100
const run = (stops: Record<string, StopView>, more: Partial<RunView> = {}): RunView => ({
  doc: 'a1',
  name: 'r',
  number,
  state: 'running',
  flows: { flow0: { order: 0 }, flow1: { order: 1 } },
  stops,
  ...more,
})

describe('a standstill', () => {
  beforeEach(() => {
    number += 1
    shownStop.take(null)
  })

  it('shows itself when it comes, and stays aside once it is put there', () => {
    expect(shownStop.take(run({ flow0: stop() }))?.at).toBe('flow0')
    expect(shownStop.shown).not.toBe('')
    shownStop.putAside()
    expect(shownStop.take(run({ flow0: stop({ text: plain('told anew') }) }))).toBeUndefined()
    expect(shownStop.shown).toBe('')
    shownStop.open()
    expect(shownStop.shown).toContain('flow0')
  })

  it('is not pushed away by a later one while somebody reads it', () => {
    const first = shownStop.take(run({ flow0: stop() }))!
    expect(shownStop.take(run({ flow0: stop(), flow1: stop({ at_s: 13 }) }))?.at).toBe('flow1')
    expect(shownStop.shown).toBe(first.key)
    shownStop.openAt('flow1')
    expect(shownStop.shown).toContain('flow1')
  })

  it('goes when the flow goes on, and the next one shows itself', () => {
    shownStop.take(run({ flow0: stop() }))
    shownStop.take(run({}))
    expect(shownStop.shown).toBe('')
    expect(shownStop.take(run({ flow0: stop({ at_s: 20 }) }))?.stop.at_s).toBe(20)
  })

  it('a flow whose others go on again is deserted no more', () => {
    const deserted = (state: string): number => {
      const flows = { flow0: { order: 0, state }, flow1: { order: 1, state: 'waiting', waits_for: ['flow0'] } }
      return standstills(run({ flow1: stop({ kind: 'deserted', subsystem: 'flow1' }) }, { flows })).length
    }
    expect([deserted('stopped'), deserted('ended'), deserted('running')]).toEqual([1, 1, 0])
  })

  it('several stand in the order in which they came', () => {
    expect(standstills(run({ flow0: stop(), flow1: stop({ at_s: 3 }) })).map(({ at }) => at)).toEqual([
      'flow1',
      'flow0',
    ])
  })

  it('an end that somebody wanted is not explained', () => {
    expect(standstills(run({ '': stop({ kind: 'user', subsystem: '' }) }))).toEqual([])
    expect(standstills(null)).toEqual([])
  })
})

describe('its title', () => {
  it('names the flow and the task', () => {
    look.language = 'en'
    expect(titleOf(run({}), 'flow1', stop({ subsystem: '' }))).toBe('Flow 1 stopped: invkin has an error')
    expect(titleOf(run({}), '', stop({ subsystem: '', task: '', kind: 'new' }))).toBe('The run stands still')
    look.language = 'es'
    expect(titleOf(run({}), 'flow0', stop({ kind: 'pressed' }))).toBe(
      'Flujo 0 se detuvo: el botón de emergencia está pulsado',
    )
    look.language = 'en'
  })
})

describe('what was said', () => {
  it('is a sentence, where the module made it one', () => {
    const said = { text: plain('cycle: ModuleError: panic button pressed'), short: plain('panic button pressed') }
    expect(inShort(stop(said))).toBe('Panic button pressed')
    const other = 'cycle: ZeroDivisionError: division by zero'
    expect(inShort(stop({ text: plain(other) }))).toBe('Cycle: ZeroDivisionError: division by zero')
  })
})

describe('its choices', () => {
  const one = stop({
    choices: [
      { verb: 'clear', subsystem: 'flow0', meaning: plain('clears invkin and repeats it') },
      { verb: 'skip', subsystem: 'flow0', meaning: plain('the same') },
      { verb: 'pass', subsystem: 'flow1', meaning: plain('lets it go on alone') },
      { verb: 'abort', meaning: plain('ends the run'), act: { t: 'Steer', line: 'abort' } },
    ],
  })

  it('stand in order, by the words of whoever knows the run', () => {
    look.language = 'en'
    expect(choicesOf(run({}), one).map(({ verb, title, meaning }) => [verb, title, meaning])).toEqual([
      ['clear', 'Try again', 'Clears invkin and repeats it.'],
      ['skip', 'Go on with another action', 'The same.'],
      ['pass', 'Let it go on alone (Flow 1)', 'Lets it go on alone.'],
      ['abort', 'End the run', 'Ends the run.'],
    ])
  })

  it('are said in the language of the page', () => {
    look.language = 'es'
    const clears = { key: 'host.clears', text: 'clears invkin', args: { tasks: ['invkin'] } }
    const text = 'clears invkin and goes on'
    const choices = [{ verb: 'clear', meaning: { key: 'host.and_goes_on', text, args: { what: clears } } }]
    expect(choicesOf(run({}), { ...one, choices })[0]!.meaning).toBe('Borra el error de invkin y sigue.')
    look.language = 'en'
  })

  it('name no task where tasks are left to the details', () => {
    const clears = { key: 'host.clears', text: 'clears invkin', args: { tasks: ['invkin'] } }
    const text = 'clears invkin and repeats “down” with the same target'
    const choices = [
      { verb: 'clear', meaning: { key: 'host.and_repeats', text, args: { what: clears, action: '“down”' } } },
    ]
    const blocked = stop({ choices, touches: [plain('the hand touches the table')] })
    expect(choicesOf(run({}), blocked)[0]!.meaning).toBe('Repeats “down” with the same target.')
    expect(choicesOf(run({}), stop({ choices }))[0]!.meaning).toContain('Clears invkin and repeats')
  })

  it('of a word that is not known stand as they are', () => {
    const choices = [{ verb: 'pray', meaning: plain('helps sometimes!') }]
    expect(choicesOf(run({}), stop({ choices }))[0]).toMatchObject({ title: 'pray', meaning: 'Helps sometimes!' })
  })
})

describe('the last seconds', () => {
  const course = (variable: string, values: unknown[]): CourseView => ({
    variable,
    unit: 'rad',
    at_s: values.map((_, k) => 10 + k),
    values,
  })

  it('of a vector show the element that went farthest', () => {
    const [one] = stopVariables(
      [
        course('Q_MEZ', [
          [0, 1, 5],
          [0, 3, 5],
          [0, 2, 5.5],
        ]),
      ],
      12,
    )
    expect([one!.element, one!.width, [...one!.stretch.t]]).toEqual([1, 3, [-2, -1, 0]])
  })

  it('each element has its own unit, where they differ', () => {
    const [one, other] = [
      {
        ...course('GRIP', [
          [0, 1],
          [0, 3],
        ]),
        unit: 'm, N',
      },
      { ...course('IS_SHUT', [0, 1]), unit: '-' },
    ]
    expect(
      stopVariables(
        [
          one,
          other,
          course('Q', [
            [1, 2],
            [1, 3],
          ]),
        ],
        12,
      ).map(({ unit }) => unit),
    ).toEqual(['N', '', 'rad'])
  })

  it('what is no number any more says most', () => {
    expect(
      stopVariables(
        [
          course('Q_REF', [
            [0, 1],
            [9, 1],
            [18, NaN],
          ]),
        ],
        12,
      )[0]!.element,
    ).toBe(1)
  })

  it('variables in which nothing happens come last', () => {
    expect(stopVariables([course('KP', [1, 1]), course('X', [1, 2])], 11).map(({ variable }) => variable)).toEqual([
      'X',
      'KP',
    ])
  })

  it('texts and vectors that change their length are left out', () => {
    expect(stopVariables([course('NAME', ['a', 'b']), course('V', [[1], [1, 2]]), course('NONE', [])], 11)).toEqual([])
  })
})

describe('what happened, in the words of the program', () => {
  const touches = [plain('the hand touches the table')]
  const stands = [plain('the hand stands at x = 1.0 cm')]
  const would = { key: 'runtime.would_step', text: 'TAU_REF[1] would step by 40 N m' }
  const failed = {
    key: 'host.entry_failed',
    text: 'cycle: TAU_REF[1] would step',
    args: { entry: 'cycle', why: would },
  }

  it('is what was in the way, and where the arm stood; the task is left to the details', () => {
    look.language = 'en'
    const blocked = stop({ text: failed, touches, stands, action: 'go down' })
    expect(titleOf(run({}), 'flow0', blocked)).toBe('Flow 0 stopped: something is in the way')
    expect(accountOf(blocked)).toEqual({
      lines: ['The hand touches the table.', 'The hand stands at x = 1.0 cm.'],
      isPlain: true,
    })
  })

  it('is that the arm would jump, where nothing is in the way', () => {
    const sudden = stop({ text: failed, action: 'go down' })
    expect(titleOf(run({}), 'flow0', sudden)).toBe('Flow 0 stopped at “go down”')
    expect(accountOf(sudden).isPlain).toBe(true)
    expect(accountOf(sudden).lines.join(' ')).toMatch(/would have to jump/)
    expect(accountOf(sudden).lines.join(' ')).not.toMatch(/TAU_REF/)
  })

  it('is what a module says, where it is no matter of the arm', () => {
    expect(accountOf(stop({ text: plain('the sensor is dead') }))).toEqual({
      lines: ['The sensor is dead'],
      isPlain: false,
    })
  })
})

describe('to begin anew', () => {
  const clear = { verb: 'clear', meaning: plain('tries again') }
  const abort = { verb: 'abort', meaning: plain('ends the run') }

  it('is offered before the end of the run, where everything can be put back', () => {
    const stands = stop({ choices: [clear, abort] })
    expect(choicesOf(run({}), stands, true).map(({ verb }) => verb)).toEqual(['clear', 'anew', 'abort'])
    expect(choicesOf(run({}), stands, false).map(({ verb }) => verb)).toEqual(['clear', 'abort'])
    expect(choicesOf(run({}), stop({ choices: [] }), true)).toEqual([])
  })

  it('needs a workcell, and none that is real', () => {
    const drives = (...worlds: string[]): ApplicationView => ({ name: 'one', order: 0, worlds: { flow0: worlds } })
    const runtime: RuntimeView = { world_kinds: { cell: 'simulated', real: 'real' } }
    expect(isAllSimulated(runtime, drives('cell'))).toBe(true)
    expect(isAllSimulated(runtime, drives('cell', 'real'))).toBe(false)
    expect(isAllSimulated(runtime, drives())).toBe(false)
    expect(isAllSimulated(runtime, undefined)).toBe(false)
  })
})
