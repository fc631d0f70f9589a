// What each lesson of the courses has to see to be done, and what only looks like it.
import type { ApplicationView, RunView, StepView } from '../../src/api.gen'
import type { LessonId } from '../../src/help/tutorial'
import {
  OPEN,
  MOVE,
  MOVE_RIGHT,
  VISIT,
  view,
  over,
  meeting,
  named,
  incomplete,
  stopped,
  ofAnother,
} from './seenProgram'

/** Per course: a lesson, what it needs to be seen, and what looks like it and is not. */
type Look = [ApplicationView, RunView | null]
export const looped = { 0: [{ ...OPEN, loop: 'A' }, OPEN, { ...OPEN, loop: 'A' }] }
const within = {
  0: [
    { ...OPEN, loop: 'A' },
    { ...OPEN, loop: 'B' },
    { ...OPEN, loop: 'B' },
    { ...OPEN, loop: 'A' },
  ],
}
const branch: StepView = { kind: 'branch', conditions: ['LAMP == 1'], flows: ['0/1/0', '0/1/1'] }
const branched = { 0: [branch], '0/1/0': [OPEN], '0/1/1': [OPEN] }
const three = {
  0: [{ ...branch, conditions: ['LAMP == 1', 'LAMP == 0'], flows: ['0/1/0', '0/1/1', '0/1/2'] }],
  '0/1/0': [OPEN],
  '0/1/1': [OPEN],
  '0/1/2': [OPEN],
}
const A = { ...MOVE, synch_tag: 'A' }
const B = { ...MOVE, synch_tag: 'B' }
const RIGHT_A = { ...MOVE_RIGHT, synch_tag: 'A' }
const parallel = { is_parallel: true }
export const LOOKS: Partial<Record<LessonId, { is: Look; isNot: Look[] }>> = {
  loopSee: {
    is: [named('wave_three', looped), over({ 2: 3 })],
    isNot: [
      [view(looped), over({ 2: 3 })],
      [named('wave_three', looped), over({ 2: 3 }, incomplete)],
      [named('wave_three', looped), null],
    ],
  },
  twoActions: {
    is: [view({ 0: [OPEN, OPEN] }), null],
    isNot: [
      [view({ 0: [OPEN] }), null],
      [view({ 0: [OPEN, MOVE] }, { holes: 1 }), null],
      [named('wave_three', looped), null],
    ],
  },
  loop: {
    is: [view(looped), null],
    isNot: [
      [view({ 0: [OPEN, OPEN] }), null],
      [named('wave_three', looped), null],
    ],
  },
  loopRun: {
    is: [view(looped), over({ 2: 2 })],
    isNot: [
      [view(looped), over({ 2: 1 })],
      [view(looped), over({ 2: 2 }, incomplete)],
      [view(looped), over({ 2: 2 }, ofAnother)],
      [view({ 0: [...looped[0], OPEN] }), over({ 2: 1, 4: 2 })],
    ],
  },
  loopWithin: {
    is: [view(within), over({ 2: 4, 3: 4 })],
    isNot: [
      [view(within), over({ 1: 4, 2: 2 })],
      [view(looped), over({ 2: 4 })],
      [view(within), over({ 2: 4 }, incomplete)],
      [view({ 0: [...looped[0], { ...OPEN, loop: 'B' }, { ...OPEN, loop: 'B' }] }), over({ 2: 4, 4: 4, 5: 4 })],
    ],
  },
  branchSee: {
    is: [named('see_the_lamp', branched), over({ 2: 1 })],
    isNot: [
      [view(branched), over({ 2: 1 })],
      [named('see_the_lamp', branched), over()],
    ],
  },
  branch: {
    is: [view(branched), null],
    isNot: [
      [view({ 0: [OPEN] }), null],
      [named('see_the_lamp', branched), null],
    ],
  },
  branchFlows: {
    is: [view(branched), null],
    isNot: [
      [view({ ...branched, '0/1/1': [] }), null],
      [view({ ...branched, 0: [{ ...branch, conditions: [''] }] }), null],
    ],
  },
  branchRun: {
    is: [view(branched), over({ 3: 1 })],
    isNot: [
      [view(branched), over()],
      [view(branched), over({ 2: 1, 3: 1 })],
      [view(branched), over({ 3: 1 }, ofAnother)],
    ],
  },
  branchMiddle: {
    is: [view(three), over({ 3: 1 })],
    isNot: [
      [view(three), over({ 2: 1 })],
      [view(three), over({ 4: 1 })],
      [view(branched), over({ 3: 1 })],
      [view(three), over({ 3: 1 }, incomplete)],
    ],
  },
  meetSee: {
    is: [named('both_wave', { 0: [A], 1: [RIGHT_A] }, parallel), over({}, meeting('A'))],
    isNot: [
      [view({ 0: [A], 1: [RIGHT_A] }, parallel), over({}, meeting('A'))],
      [named('both_wave', { 0: [A], 1: [RIGHT_A] }, parallel), over()],
    ],
  },
  twoFlows: {
    is: [view({ 0: [OPEN], 1: [OPEN] }, parallel), null],
    isNot: [
      [view({ 0: [OPEN], 1: [OPEN] }), null],
      [view({ 0: [OPEN] }, parallel), null],
    ],
  },
  tags: {
    is: [view({ 0: [A], 1: [RIGHT_A] }, parallel), null],
    isNot: [
      [view({ 0: [A, A], 1: [MOVE_RIGHT] }, parallel), null],
      [named('both_wave', { 0: [A], 1: [RIGHT_A] }, parallel), null],
    ],
  },
  meet: {
    is: [view({ 0: [A], 1: [RIGHT_A] }, parallel), over({}, meeting('A'))],
    isNot: [
      [view({ 0: [A], 1: [RIGHT_A] }, parallel), over()],
      [view({ 0: [A], 1: [RIGHT_A] }, parallel), over({}, meeting('B'))],
    ],
  },
  meetTwice: {
    is: [view({ 0: [A, B], 1: [A, B] }, parallel), over({}, meeting('A', 'B'))],
    isNot: [
      [view({ 0: [A, B], 1: [A, B] }, parallel), over({}, meeting('A', 'A'))],
      [view({ 0: [A, B], 1: [A, B] }, parallel), over({}, { ...meeting('A', 'B'), ...incomplete })],
    ],
  },
  armsSee: {
    is: [named('two_arms', { 0: [MOVE], 1: [MOVE_RIGHT] }, parallel), over({ 1: 1, 2: 1 })],
    isNot: [
      [view({ 0: [MOVE], 1: [MOVE_RIGHT] }, parallel), over({ 1: 1, 2: 1 })],
      [named('two_arms', { 0: [MOVE], 1: [MOVE_RIGHT] }, parallel), over({ 1: 1 })],
    ],
  },
  armsFlows: {
    is: [view({ 0: [MOVE], 1: [MOVE_RIGHT] }, parallel), null],
    isNot: [
      [view({ 0: [MOVE], 1: [MOVE] }, parallel), null],
      [view({ 0: [MOVE], 1: [OPEN] }, parallel), null],
      [view({ 0: [MOVE], 1: [MOVE_RIGHT] }), null],
      [view({ 0: [MOVE], 1: [MOVE_RIGHT] }, { ...parallel, holes: 1 }), null],
      [named('two_arms', { 0: [MOVE], 1: [MOVE_RIGHT] }, parallel), null],
    ],
  },
  armsRun: {
    is: [view({ 0: [MOVE], 1: [MOVE_RIGHT] }, parallel), over({ 1: 1, 2: 1 })],
    isNot: [
      [view({ 0: [MOVE], 1: [MOVE_RIGHT] }, parallel), over({ 2: 1 })],
      [view({ 0: [MOVE], 1: [MOVE_RIGHT] }, parallel), over({ 1: 1, 2: 1 }, incomplete)],
    ],
  },
  armsWait: {
    is: [view({ 0: [MOVE, A], 1: [RIGHT_A] }, parallel), over({ 1: 1, 2: 1, 3: 1 }, meeting('A'))],
    isNot: [
      [view({ 0: [A, MOVE], 1: [RIGHT_A] }, parallel), over({ 1: 1, 2: 1, 3: 1 }, meeting('A'))],
      [view({ 0: [MOVE, A], 1: [MOVE_RIGHT, RIGHT_A] }, parallel), over({ 1: 1, 2: 1, 3: 1 }, meeting('A'))],
      [view({ 0: [MOVE, A], 1: [RIGHT_A] }, parallel), over({ 1: 1, 2: 1, 3: 1 })],
    ],
  },
  seekSee: {
    is: [named('try_to_grasp', { 0: [MOVE] }), over()],
    isNot: [
      [view({ 0: [MOVE] }), over()],
      [named('try_to_grasp', { 0: [MOVE] }, { is_dirty: true }), over()],
      [named('try_to_grasp', { 0: [MOVE] }), over({}, incomplete)],
    ],
  },
  seekRefused: {
    is: [named('try_to_grasp', { 0: [MOVE] }, { holes: 1 }), null],
    isNot: [
      [named('try_to_grasp', { 0: [MOVE] }), null],
      [view({ 0: [MOVE] }, { holes: 1 }), null],
    ],
  },
  seekMended: {
    is: [named('try_to_grasp', { 0: [MOVE] }), null],
    isNot: [
      [named('try_to_grasp', { 0: [MOVE] }, { holes: 1 }), null],
      [view({ 0: [MOVE] }), null],
    ],
  },
  seekStops: {
    is: [named('try_to_grasp', { 0: [MOVE] }, { is_dirty: true }), over({}, { ...stopped, state: 'running' })],
    isNot: [
      [named('try_to_grasp', { 0: [MOVE] }), over({}, stopped)],
      [named('try_to_grasp', { 0: [MOVE] }, { is_dirty: true }), over()],
      [named('try_to_grasp', { 0: [MOVE] }, { is_dirty: true }), over({}, { ...stopped, ...ofAnother })],
      [view({ 0: [MOVE] }, { is_dirty: true }), over({}, stopped)],
    ],
  },
  seekOwn: {
    is: [named('try_to_grasp', { 0: [MOVE] }, { is_dirty: true }), over()],
    isNot: [
      [named('try_to_grasp', { 0: [MOVE] }), over()],
      [named('try_to_grasp', { 0: [MOVE] }, { is_dirty: true }), over({}, incomplete)],
      [view({ 0: [MOVE] }, { is_dirty: true }), over()],
    ],
  },
  nestSee: {
    is: [named('visit_boxes', { 0: [VISIT, MOVE] }), over({ 1: 1 })],
    isNot: [
      [view({ 0: [VISIT, MOVE] }), over({ 1: 1 })],
      [named('visit_boxes', { 0: [VISIT, MOVE] }), over({ 2: 1 })],
    ],
  },
  nestInside: { is: [named('visit', { 0: [MOVE] }), null], isNot: [[named('visit_boxes', { 0: [VISIT] }), null]] },
  nestUse: {
    is: [view({ 0: [VISIT] }), null],
    isNot: [
      [view({ 0: [VISIT] }, { holes: 1 }), null],
      [view({ 0: [MOVE] }), null],
      [named('visit_boxes', { 0: [VISIT] }), null],
    ],
  },
  nestRun: {
    is: [view({ 0: [VISIT] }), over({ 1: 1 })],
    isNot: [
      [view({ 0: [VISIT] }), over({ 1: 1 }, incomplete)],
      [view({ 0: [MOVE] }), over({ 1: 1 })],
      [named('visit_boxes', { 0: [VISIT] }), over({ 1: 1 })],
    ],
  },
  nestOwn: {
    is: [view({ 0: [{ ...VISIT, name: 'mine' }] }), over({ 1: 1 })],
    isNot: [
      [view({ 0: [VISIT] }), over({ 1: 1 })],
      [view({ 0: [{ ...VISIT, name: 'gone' }] }), over({ 1: 1 })],
      [view({ 0: [{ ...VISIT, name: 'mine' }] }), null],
    ],
  },
}
