// What the environment gives as a reason is shown as a sentence in the reader's language, wherever the page shows it.
import type { Component } from 'svelte'
import { render } from 'svelte/server'
import { afterAll, beforeAll, describe, expect, test, vi } from 'vitest'
import type {
  ApplicationView,
  AskView,
  DocumentView,
  Objection,
  OnikonView,
  RecordingView,
  Remedy,
  RunView,
  Tree,
} from '../src/api.gen'
import { addLine, clearLog } from '../src/act/log.svelte'
import { refused } from '../src/act/refused.svelte'
import { notify, toasts } from '../src/act/toasts.svelte'
import StateCard from '../src/canvas/StateCard.svelte'
import CarriedTask from '../src/canvas/CarriedTask.svelte'
import TroubleCard from '../src/dictionary/TroubleCard.svelte'
import { carriedTask } from '../src/gesture/carry.svelte'
import ReasonCard from '../src/library/ReasonCard.svelte'
import { desk, fullTree } from '../src/link/desk.svelte'
import { Refusal } from '../src/link/refusal'
import { copied, filtered } from '../src/monitor/lines'
import Log from '../src/monitor/Log.svelte'
import Problems from '../src/monitor/Problems.svelte'
import { shownStop } from '../src/progress/shownStop.svelte'
import Question from '../src/question/Question.svelte'
import RobotChoice from '../src/redirect/RobotChoice.svelte'
import StepTroubles from '../src/redirect/StepTroubles.svelte'
import ReviewBar from '../src/review/ReviewBar.svelte'
import FlowLine from '../src/run/FlowLine.svelte'
import Readiness from '../src/run/Readiness.svelte'
import Result from '../src/run/Result.svelte'
import ReviewRun from '../src/run/ReviewRun.svelte'
import RunNotes from '../src/run/RunNotes.svelte'
import { Box } from '../src/scene/scene.svelte'
import ConnectPanel from '../src/shell/ConnectPanel.svelte'
import RefusalCard from '../src/shell/RefusalCard.svelte'
import RuntimeChip from '../src/shell/RuntimeChip.svelte'
import Stop from '../src/shell/Stop.svelte'
import Toasts from '../src/shell/Toasts.svelte'
import { canvas } from '../src/state/canvas.svelte'
import { look } from '../src/state/look.svelte'
import StopPanel from '../src/stop/StopPanel.svelte'
import Trouble from '../src/task/Trouble.svelte'
import type { Reason } from '../src/texts/say'
import Remedies from '../src/widgets/Remedies.svelte'

const reason: Reason = { key: 'test.reason', text: 'flow 2 stands still' }
const remedies: Remedy[] = [{ label: { key: 'test.remedy', text: 'Let it go on' } }]
const objections: Objection[] = [{ text: reason, remedies }]
const ask: AskView = { items: [], reason }

const application: ApplicationView = {
  name: 'play',
  order: 0,
  steps: { 4: { kind: 'icon', name: 'wave', note: reason } },
  flows: { 0: { steps: [4] } },
  faults: { 1: { text: reason, step: 4, remedies }, 2: { text: reason, level: 'warning', remedies } },
}
const run: RunView = {
  doc: 'a1',
  name: 'play',
  number: 1,
  state: 'running',
  flows: { flow0: { order: 0, state: 'waiting', text: reason, waits_for: ['flow1'] }, flow1: { order: 1 } },
  stops: {
    flow0: {
      text: reason,
      kind: 'error',
      at_s: 1,
      subsystem: 'flow0',
      task: 'wave',
      choices: [{ verb: 'clear', meaning: { key: 'test.meaning', text: 'the step is begun anew' } }],
    },
  },
  notes: [reason],
  cause: reason,
}
const configuration: DocumentView = {
  name: 'arm',
  order: 0,
  greyed: { wave: objections },
  problems: { 1: { text: reason, level: 'fault', remedies }, 2: { text: reason, level: 'note', show: null } },
  tasks: { wave: { x: 0, y: 0, state: 'ERROR', note: reason, error: { text: reason, remedies } } },
}
const onikon: OnikonView = {
  type: 'Joint target',
  role: 'target',
  order: 0,
  dictionary: 'home',
  left: '',
  right: '',
  picture: '',
  trouble: reason,
}
const recording: RecordingView = {
  path: '/r.mcap',
  name: 'play',
  cause: reason,
  marks: [{ at_s: 0, kind: 'error', text: reason }],
  notes: [reason],
  cannot_continue: reason,
}
const tree: Tree = {
  applications: { a1: application },
  documents: { d1: configuration },
  tasks: { wave: { name: 'wave' } as NonNullable<Tree['tasks']>[string] },
  onikons: { home: onikon },
  runtime: { state: 'lost', text: reason, is_stopped: true, stop_text: reason },
  run,
}

const nothing = (): void => undefined
const tabs = (() => undefined) as never
const box = { name: 'wave', x: 0, y: 0, width: 100, height: 60, rect: { x: 0, y: 0, w: 100, h: 60 } } as unknown as Box

/** What stands in a component's elements and attributes. */
function shown(component: unknown, properties: object = {}): string {
  return render(component as Component, { props: properties }).body
}

beforeAll(() => {
  vi.stubGlobal('window', { innerWidth: 1000, innerHeight: 800 })
  vi.stubGlobal('document', { hidden: false, activeElement: null })
  look.language = 'en'
  look.sounds = false
  canvas.doc = 'd1'
  desk.tree = fullTree(tree)
  carriedTask.name = 'wave'
})
afterAll(() => vi.unstubAllGlobals())

const COMPONENTS: [string, unknown, object][] = [
  ['buttons of remedies', Remedies, { remedies, run: nothing }],
  ['problems of a configuration', Problems, { tabs }],
  ['why a task may not be placed', ReasonCard, { name: 'wave', reasons: objections, objections }],
  ['why an icon cannot run', TroubleCard, { name: 'home', onikon }],
  ['a task of the library that is carried', CarriedTask, {}],
  ['a recorded run that ended', ReviewRun, {}],
  ['what is wrong with a step', StepTroubles, { app: application, step: 4 }],
  ['an error beside a task', StateCard, { box, placed: configuration.tasks!.wave! }],
  ['a note beside a task', StateCard, { box, placed: { x: 0, y: 0, state: 'WAITING', note: reason } }],
  ['an error of a task', Trouble, { error: { text: reason, remedies }, note: '', name: 'wave' }],
  ['a question that was refused', Question, { ask, send: nothing }],
  ['what keeps an application from running', Readiness, { app: application, doc: 'a1', isAgain: false }],
  ['what a flow waits for', FlowLine, { run, name: 'flow0', isOnly: false }],
  ['notes of a run', RunNotes, { run }],
  ['how a run went', Result, { run: { ...run, state: 'over' } }],
  ['the runtime that is lost', ConnectPanel, {}],
  ['the runtime in the head line', RuntimeChip, {}],
  ['that everything is stopped', Stop, {}],
  [
    'who may stand for whom',
    RobotChoice,
    { seat: { task: 'wave', taken_by: 'wave', candidates: [{ name: 'arm', reasons: [reason] }] }, choose: nothing },
  ],
]

describe('a reason is shown as its sentence', () => {
  test.each(COMPONENTS)('in %s', (_, component, properties) => {
    const body = shown(component, properties)
    expect(body).not.toContain('[object Object]')
    expect(body).toMatch(/flow 2 stands still|Let it go on/)
  })

  test('in a refusal, with its fields and remedies', () => {
    refused.why = new Refusal(reason, remedies, { name: { key: 'test.field', text: 'a name is missing' } })
    const body = shown(RefusalCard)
    refused.why = undefined
    expect(body).not.toContain('[object Object]')
    for (const sentence of ['flow 2 stands still', 'Let it go on', 'a name is missing'])
      expect(body).toContain(sentence)
  })

  test('in the log, where it is also found and copied by its words', () => {
    clearLog()
    const line = addLine({ t: 'Say', level: 'error', text: reason })
    expect(shown(Log, { tabs })).toContain('flow 2 stands still')
    expect(filtered([line], 'stands')).toEqual([line])
    expect(copied([line])).toContain('flow 2 stands still')
  })

  test('in news, where the same sentence is shown once', () => {
    vi.useFakeTimers()
    for (let times = 0; times < 2; times++) notify({ t: 'Say', level: 'error', text: { ...reason } })
    expect(toasts.lines).toHaveLength(1)
    expect(shown(Toasts)).toContain('flow 2 stands still')
    vi.useRealTimers()
  })

  test('in a recording that is looked at', () => {
    desk.live.review = { recording }
    const body = shown(ReviewBar)
    desk.live.review = null
    expect(body).not.toContain('[object Object]')
    expect(body).toContain('flow 2 stands still')
  })

  test('in the stop explained', () => {
    shownStop.take(run)
    const body = shown(StopPanel)
    expect(body).not.toContain('[object Object]')
    expect(body).toContain('Flow 2 stands still')
    expect(body).toContain('The step is begun anew.')
  })
})
