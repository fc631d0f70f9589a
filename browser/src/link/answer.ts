// What the stand-in does with acts: a few are shown for real, the others are only accepted.
import type { AnyAct, AnyMessage } from '../api.gen'
import { desk } from './desk.svelte'
import { plain } from '../texts/say'

type SayTo = (message: AnyMessage) => void
type Changes = [string[], unknown][]

let pump: ReturnType<typeof setInterval> | undefined

export function answer(act: AnyAct, cid: number, say: SayTo): void {
  if (act.t === 'Watch') watch(act, say)
  if (act.t === 'Place' && desk.tree.documents[act.doc]?.greyed?.[act.task]) {
    const [why] = desk.tree.documents[act.doc]!.greyed![act.task]!
    say({ t: 'Refused', cid, reason: why!.text, remedies: why!.remedies ?? [] })
    return
  }
  if (act.t === 'Save')
    say({ t: 'Say', level: 'success', text: plain(`${documentsOf()[act.doc]?.name} is saved.`), doc: act.doc })
  if (act.t === 'SaveTask')
    say({
      t: 'Say',
      level: 'error',
      text: plain(`${act.task}.rmod could not be written.`),
      doc: 'd1',
      where: { t: 'ShowTask', task: act.task },
    })
  const changes = changesOf(act)
  if (changes.length) say({ t: 'Patch', rev: desk.rev + 1, changes })
  say({ t: 'Ok', cid, rev: desk.rev, value: valueOf(act) })
}

function changesOf(act: AnyAct): Changes {
  const documents = documentsOf()
  switch (act.t) {
    case 'Move':
      return [
        ...Object.entries(act.tasks ?? {}).flatMap(([name, at]) => corner(act.doc, 'tasks', name, at)),
        ...Object.entries(act.loci ?? {}).flatMap(([name, at]) => corner(act.doc, 'loci', name, at)),
      ]
    case 'Toggle': {
      const isOn = documents[act.doc]?.tasks?.[act.task]?.state === 'ON'
      return [[['documents', act.doc, 'tasks', act.task, 'state'], isOn ? 'OFF' : 'ON']]
    }
    case 'Flip':
      return act.tasks.map(
        (name) =>
          [['documents', act.doc, 'tasks', name, 'in_left'], documents[act.doc]?.tasks?.[name]?.in_left === false] as [
            string[],
            unknown,
          ],
      )
    case 'Place':
      return [
        [['documents', act.doc, 'tasks', act.task], { x: act.x, y: act.y, state: 'OFF', rtpu: act.rtpu || 'rt0' }],
      ]
    case 'Remove':
    case 'Cut':
      return act.tasks.map((name) => [['documents', act.doc, 'tasks', name], null] as [string[], unknown])
    case 'Show':
      return act.svars.map(
        (name) => [['documents', act.doc, 'loci', name, 'is_shown'], act.is_shown] as [string[], unknown],
      )
    case 'Group':
      return [[['documents', act.doc, 'groups', act.name], { tasks: act.tasks }]]
    case 'Ungroup':
      return [[['documents', act.doc, 'groups', act.name], null]]
    case 'TurnGroup':
      return (documents[act.doc]?.groups?.[act.name]?.tasks ?? []).map(
        (name) => [['documents', act.doc, 'tasks', name, 'state'], act.is_on ? 'ON' : 'OFF'] as [string[], unknown],
      )
    case 'Stop':
      return [
        [['runtime', 'is_stopped'], true],
        [['runtime', 'stop_text'], 'You pressed Stop. Every drive holds.'],
      ]
    case 'Reset':
      return [
        [['runtime', 'is_stopped'], null],
        [['runtime', 'stop_text'], null],
      ]
    case 'Rate':
      return [[['documents', act.doc, 'tasks', act.task, 'hz'], act.hz || null]]
    case 'New':
      return [[['documents', `d${desk.rev + 10}`], { name: `Untitled-${desk.rev + 2}`, order: desk.rev + 10 }]]
    case 'Close':
      return [[['documents', act.doc], null]]
    default:
      return []
  }
}

const documentsOf = () => desk.tree.documents
const corner = (doc: string, kind: string, name: string, [x, y]: [number, number]): Changes => [
  [['documents', doc, kind, name, 'x'], x],
  [['documents', doc, kind, name, 'y'], y],
]

function valueOf(act: AnyAct): unknown {
  if (act.t === 'ReadText') {
    const text = `# ${act.task}\nfrom onika.module import Module\n\n\nclass ${act.task}(Module):\n    """Sample."""\n`
    return {
      path: `/lab/generic/module/${act.task}.${act.kind === 'code' ? 'py' : 'rmod'}`,
      text,
      stamp: '1',
      faults: [[5, 'a class name begins with a capital']],
    }
  }
  if (act.t === 'Draft')
    return {
      name: 'joint_move',
      type: 'Joint job',
      left_edge: 'none',
      right_edge: 'joint',
      warnings: ['LED is read by nobody.'],
    }
  if (act.t === 'Copy') return 'TASK pd'
  if (act.t === 'Check') return ['Nothing is wrong with joint_move.']
  return undefined
}

function watch(act: Extract<AnyAct, { t: 'Watch' }>, say: SayTo): void {
  clearInterval(pump)
  if (!act.variables?.length && !act.figures) return
  pump = setInterval(
    () => {
      const at_s = performance.now() / 1000
      const values = Object.fromEntries(
        (act.variables ?? []).map((key, k) => [
          key,
          [1, 2, 3, 4, 5, 6].map((n) => Math.sin(at_s * (0.4 + n / 9) + n + k)),
        ]),
      )
      const figures = act.figures
        ? Object.fromEntries(
            Object.keys(desk.tree.documents['d1']?.tasks ?? {}).map((name) => [
              `d1/${name}`,
              {
                'ref-F': 500,
                'mez-F': 499.9,
                cycle: Math.round(at_s * 500),
                miss: 0,
                'avg-C': 0.014,
                'max-C': 0.033,
                'avg-U': 0.007,
                warn: 0,
              },
            ]),
          )
        : {}
      say({ t: 'Frame', at_s, values, figures })
    },
    1000 / (act.hz ?? 30),
  )
}
