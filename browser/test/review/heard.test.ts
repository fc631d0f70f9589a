// What the environment says of recorded runs and of faults before a run is understood in Spanish.
import { expect, it } from 'vitest'
import { heard } from '../../src/texts/heard'

it.each([
  ['scara stood for puma', 'scara hizo de puma'],
  ['scara stood for puma in flow 1', 'scara hizo de puma en el flujo 1'],
  ['flow0/DH: 4 × 4 values, in the other 6 × 4 values', 'flow0/DH: 4 × 4 valores; en la otra, 6 × 4 valores'],
  [
    'it cannot be continued: expected a recording of a run, found no such file',
    'no se puede continuar: se esperaba la grabación de una ejecución; el archivo ya no está',
  ],
  [
    'it was recorded in wall time: continued from an instant, it goes on nearly as then, not exactly',
    'se grabó en tiempo real: continuada desde un instante, sigue casi como entonces, no exactamente',
  ],
  [
    '1 target is re-resolved for scara, by the pose that it is for puma',
    '1 objetivo se calcula de nuevo para scara, por la pose que es para puma',
  ],
  [
    '4 targets are re-resolved for scara, by the poses that they are for puma',
    '4 objetivos se calculan de nuevo para scara, por las poses que son para puma',
  ],
  [
    'a (in aC) and b (in bC) have one module, m: they cannot live in one flow',
    'a (in aC) and b (in bC) usan el mismo módulo, m: no pueden estar en un mismo flujo',
  ],
])('%s', (said, words) => expect(heard(said, 'es')).toBe(words))
