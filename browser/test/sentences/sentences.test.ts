// R-X11: a program reads itself aloud as plain sentences, in English and in Spanish.
import { describe, expect, it } from 'vitest'
import type { ApplicationView, StepView, TypeView } from '../../src/api.gen'
import { en } from '../../src/texts/en'
import { texts as es } from '../../src/texts/es'
import { briefs, tell } from '../../src/sentences/sentences'
import { asText, textOf, type Connectives } from '../../src/sentences/tale'

const english: Connectives = { code: 'en', say: (key) => en[key] }
const spanish: Connectives = { code: 'es', say: (key) => es[key] }
const item = (name: string, count: number) => ({ name, type: 'double', count })
const TYPES: Record<string, TypeView> = {
  'Joint object': {
    order: 1,
    role: 'target',
    left: 'j',
    right: 'n',
    items: [item('endpoint', 6), item('duration', 1)],
  },
  'Pause object': { order: 2, role: 'target', left: 'p', right: 'n', items: [item('duration', 1)] },
}

const job = (description: string, more: Partial<StepView> = {}): StepView => ({
  name: 'jmoveC',
  type: 'Joint job',
  role: 'job',
  description,
  ...more,
})
const joint = (description: string, seconds: string, more: Partial<StepView> = {}): StepView => ({
  type: 'Joint object',
  role: 'target',
  description,
  is_joined: true,
  values: [['0', '0', '0', '0', '0', '0'], [seconds]],
  ...more,
})
const hole = (...wants: string[]): StepView => ({ kind: 'hole', wants, is_joined: wants.length > 0 })

/** Flows by their paths, each with its steps by their numbers. */
function app(flows: Record<string, Record<number, StepView>>, more: Partial<ApplicationView> = {}): ApplicationView {
  return {
    name: 'one',
    order: 1,
    flows: Object.fromEntries(
      Object.entries(flows).map(([path, steps]) => [path, { steps: Object.keys(steps).map(Number) }]),
    ),
    steps: Object.assign({}, ...Object.values(flows)) as Record<string, StepView>,
    ...more,
  }
}

const lines = (one: ApplicationView, connectives = english): string[] =>
  tell(one, TYPES, connectives).flatMap((tale) => tale.sentences.map(textOf))
const said = (steps: Record<number, StepView>, connectives = english): string[] => lines(app({ 0: steps }), connectives)

describe('an action', () => {
  it('is its description, with a capital and a full stop', () =>
    expect(said({ 1: job('open the hand') })).toEqual(['Open the hand.']))

  it('goes on into its target where its words ask for one', () => {
    expect(said({ 1: job('turn to'), 2: joint('above square', '2') })).toEqual(['Turn to above square in 2 s.'])
  })

  it('goes on into its target where the words of that follow by themselves', () => {
    expect(said({ 1: job('move the joints'), 2: joint('above the box', '2.3') })).toEqual([
      'Move the joints above the box in 2.3 s.',
    ])
    expect(said({ 1: job('wait, drives hold'), 2: joint('for ten', 'x') })).toEqual(['Wait, drives hold: for ten.'])
  })

  it('is set apart from its target where both could stand by themselves', () => {
    expect(said({ 1: job('move the joints'), 2: joint('upright', '2.3') })).toEqual([
      'Move the joints: upright in 2.3 s.',
    ])
    expect(said({ 1: job('repeat the loop'), 2: joint('three times', 'x') })).toEqual(['Repeat the loop three times.'])
  })

  it('has its time behind a comma where the target is long', () => {
    expect(said({ 1: job('go'), 2: joint('to where the box with the triangle begins', '1') })).toEqual([
      'Go to where the box with the triangle begins, in 1 s.',
    ])
  })

  it('has its time behind a comma where the target has commas of its own', () => {
    expect(said({ 1: job('move the joints'), 2: joint('home, out of the way', '3.0') })).toEqual([
      'Move the joints: home, out of the way, in 3 s.',
    ])
  })

  it('says no time twice where the target is a time', () => {
    const pause: StepView = {
      type: 'Pause object',
      role: 'target',
      description: 'for half a second',
      is_joined: true,
      values: [['0.5']],
    }
    expect(said({ 1: job('wait'), 2: pause })).toEqual(['Wait for half a second.'])
    expect(said({ 1: job('wait'), 2: { ...pause, description: '', name: 'half' } })).toEqual(['Wait: half in 0.5 s.'])
  })

  it('names all its targets in order', () => {
    expect(said({ 1: job('move by way of'), 2: joint('aside', '2'), 3: joint('home', '1') })).toEqual([
      'Move by way of aside in 2 s; then home in 1 s.',
    ])
  })

  it('has its name where nobody has described it', () => {
    expect(said({ 1: job(''), 2: joint('', 'x', { name: 'home' }) })).toEqual(['JmoveC: home.'])
    expect(said({ 1: { role: 'job' } })).toEqual(['An icon without a name.'])
  })

  it('does not end with two full stops', () => expect(said({ 1: job('Open the hand.') })).toEqual(['Open the hand.']))

  it('that is an application says which', () => {
    expect(said({ 1: job('wave', { role: 'application', name: 'visit' }), 2: joint('home', '1') })).toEqual([
      'Wave: home in 1 s (application visit).',
    ])
  })
})

describe('in Spanish', () => {
  it('the words of an icon in that language are taken where it has them', () => {
    const steps = {
      1: job('turn to', { words: { es: 'girar hasta' } }),
      2: joint('above square', '2.5', { words: { es: 'encima del cuadrado' } }),
    }
    expect(said(steps, spanish)).toEqual(['Girar hasta encima del cuadrado en 2,5 s.'])
    expect(said(steps)).toEqual(['Turn to above square in 2.5 s.'])
  })

  it('the words between are Spanish also where the descriptions are not', () => {
    expect(said({ 1: job('open the hand', { breaks: true }), 2: hole() }, spanish)).toEqual([
      'Open the hand, y luego una pausa.',
      'Aquí falta una acción.',
    ])
    expect(said({ 1: job('abrir'), 2: hole('Joint object') }, spanish)).toEqual([
      'Abrir: aquí falta un objetivo de tipo Joint.',
    ])
  })

  it('loops and conditions are told too', () => {
    const steps = {
      1: job('abrir', { loop: 'a' }),
      2: job('mirar', { loop: 'a', is_test: true, loop_if: 'GRIP[0] < 0.05' }),
    }
    expect(said(steps, spanish)[2]).toBe('Las acciones 1 a 2 se repiten mientras GRIP[0] es menor que 0,05 (a).')
  })
})

describe('marks', () => {
  it('a breakpoint pauses behind the action, always or where something holds', () => {
    expect(said({ 1: job('open', { breaks: true }) })).toEqual(['Open, then pause.'])
    expect(said({ 1: job('open', { breaks: true, break_if: 'LAMP == 1' }) })).toEqual([
      'Open, then pause if LAMP is 1.',
    ])
  })

  it('flows that meet at a tag are told together', () => {
    const flows = {
      0: { 1: job('turn to', { synch_tag: 'a' }), 2: joint('home', '3') },
      1: { 3: job('wave', { synch_tag: 'a' }) },
      2: { 4: job('wave', { synch_tag: 'b' }) },
    }
    expect(lines(app(flows, { is_parallel: true }))).toEqual([
      'Together with flow 1 (a): turn to home in 3 s.',
      'Together with flow 0 (a): wave.',
      'At b, which no other flow has: wave.',
    ])
    expect(lines(app(flows))[0]).toBe('Turn to home in 3 s.') // flows of which one runs do not meet
  })

  it('three that meet are all named', () => {
    const one = (n: number) => ({ [n]: job('go', { synch_tag: 'a' }) })
    expect(lines(app({ 0: one(1), 1: one(2), 2: one(3) }, { is_parallel: true }))[0]).toBe(
      'Together with flow 1 and flow 2 (a): go.',
    )
  })
})

describe('loops', () => {
  it('are told at their test, which comes last', () => {
    const steps = {
      1: job('open'),
      2: job('close', { loop: 'wave' }),
      3: job('count to', { loop: 'wave', is_test: true }),
      4: joint('three', 'x'),
    }
    expect(said(steps)).toEqual([
      'Open.',
      'Close.',
      'Count to three.',
      'Repeat actions 2 to 3 while action 3 says so (wave).',
    ])
  })

  it('are told at their test, which comes first', () => {
    const steps = {
      1: job('look', { loop: 'a', is_test: true, loop_if: 'X >= 2' }),
      2: job('open'),
      3: job('close', { loop: 'a' }),
      4: job('rest'),
    }
    expect(said(steps)).toEqual([
      'Look.',
      'While X is at least 2, do actions 1 to 3 and come back (a).',
      'Open.',
      'Close.',
      'Rest.',
    ])
  })

  it('that are not whole are said to be so', () => {
    expect(said({ 1: job('open', { loop: 'a', is_test: true }) })[1]).toBe(
      'The loop a needs two ends, and a test at one of them.',
    )
    expect(
      said({ 1: job('open', { loop: 'a' }), 2: job('close', { loop: 'a' }) }).filter((line) =>
        line.startsWith('The loop'),
      ),
    ).toHaveLength(2)
  })
})

describe('what is missing', () => {
  it('is said inside the action it belongs to', () => {
    expect(said({ 1: job('go straight'), 2: hole('Cartesian object') })).toEqual([
      'Go straight: a Cartesian target is missing here.',
    ])
    expect(said({ 1: job('turn to'), 2: hole('Angle object', 'Joint object') })).toEqual([
      'Turn to: an Angle or Joint target is missing here.',
    ])
  })

  it('is said by itself elsewhere', () => {
    expect(said({ 1: hole() })).toEqual(['An action is missing here.'])
    expect(said({ 1: { ...hole('Cartesian object'), is_joined: false } })).toEqual([
      'A Cartesian target is missing here.',
    ])
    expect(said({ 1: joint('home', '1', { is_joined: false }) })).toEqual(['Home: a target without a job before it.'])
  })

  it('an empty flow says so', () => expect(said({})).toEqual(['Nothing happens yet.']))
})

describe('branches', () => {
  const steps = {
    1: job('look'),
    17: { kind: 'branch', flows: ['0/17/0', '0/17/1', '0/17/2'], conditions: ['LAMP == 1', 'LAMP > 1'] } as StepView,
    5: job('rest'),
  }
  const branched = app({
    0: steps,
    '0/17/0': { 2: job('open') },
    '0/17/1': { 3: job('close'), 4: job('wave') },
    '0/17/2': {},
  })
  branched.flows!['0']!.steps = [1, 17, 5]

  it('are told case by case, and numbers go on through them', () => {
    expect(asText(tell(branched, TYPES, english))).toBe(
      [
        '1. Look.',
        'If LAMP is 1:',
        '  2. Open.',
        'Else, if LAMP is above 1:',
        '  3. Close.',
        '  4. Wave.',
        'Else:',
        '  Nothing; go on.',
        '5. Rest.',
      ].join('\n'),
    )
  })

  it('without conditions go by what the action before says', () => {
    const two = {
      ...branched,
      steps: { ...branched.steps, 17: { kind: 'branch', flows: ['0/17/0', '0/17/2'] } as StepView },
    }
    expect(lines(two)).toEqual([
      'Look.',
      'If the action before chooses 0:',
      'Open.',
      'If the action before chooses 1:',
      'Nothing; go on.',
      'Rest.',
    ])
  })

  it('inside a loop count among its actions', () => {
    const looped = {
      ...branched,
      steps: { ...branched.steps, 1: job('look', { loop: 'a', is_test: true }), 5: job('rest', { loop: 'a' }) },
    }
    expect(lines(looped)[1]).toBe('While action 1 says so, do actions 1 to 5 and come back (a).')
  })
})

describe('several flows', () => {
  it('of which one runs say when', () => {
    const tales = tell(app({ 0: { 1: job('open') }, 1: { 2: job('close') } }), TYPES, english)
    expect(tales.map(({ title, note }) => [title, note])).toEqual([
      ['Flow 0', 'runs unless another one is chosen'],
      ['Flow 1', 'runs only inside another application, where the action before it chooses 1'],
    ])
    expect(asText(tales)).toBe(
      'Flow 0 – runs unless another one is chosen\n1. Open.\n\nFlow 1 – runs only inside another application, where the action before it chooses 1\n1. Close.',
    )
  })

  it('side by side need no such word, and more than ten stand in order', () => {
    const many = Object.fromEntries(Array.from({ length: 11 }, (_, k) => [String(k), { [k + 1]: job('go') }]))
    const tales = tell(app(many, { is_parallel: true }), TYPES, english)
    expect(tales.map((tale) => tale.note).join('')).toBe('')
    expect(tales.map((tale) => tale.path)).toEqual(Array.from({ length: 11 }, (_, k) => String(k)))
  })
})

describe('a sentence', () => {
  it('knows all the steps it speaks of, and where a click goes', () => {
    const [sentence] = tell(app({ 0: { 1: job('turn to'), 2: joint('home', '1') } }), TYPES, english)[0]!.sentences
    expect([sentence!.step, sentence!.steps, sentence!.number, sentence!.kind]).toEqual([1, [1, 2], 1, 'action'])
  })

  it('marks its target, its marks and its faults', () => {
    const kinds = (steps: Record<number, StepView>): unknown[] =>
      tell(app({ 0: steps }), TYPES, english)[0]!.sentences[0]!.parts.map((part) => part.kind)
    expect(kinds({ 1: job('turn to'), 2: joint('home', '1') })).toContain('target')
    expect(kinds({ 1: job('open', { breaks: true }) })).toContain('mark')
    expect(kinds({ 1: job('turn to'), 2: hole('Joint object') })).toContain('fault')
  })
})

describe('a condition that is not understood', () => {
  it('stands as it is', () =>
    expect(said({ 1: job('open', { breaks: true, break_if: 'A near B' }) })).toEqual(['Open, then pause if A near B.']))
})

describe('in brief', () => {
  const one = app({ 0: { 1: job('turn to', { breaks: true }), 2: joint('home', '1') } })

  it('an action is told without its marks and times, by any of its steps', () => {
    expect(briefs(one, TYPES, english)).toEqual(
      new Map([
        [1, 'turn to home'],
        [2, 'turn to home'],
      ]),
    )
  })
})
