// Spanish: courses of lessons.
import type { enCourses } from './en.courses'

export const esCourses: Record<keyof typeof enCourses, string> = {
  'tutorial.course': 'Curso',
  'tutorial.course.first': 'Primeros pasos',
  'tutorial.course.loops': 'Bucles',
  'tutorial.course.branches': 'Bifurcaciones',
  'tutorial.course.meetings': 'Flujos que se encuentran',
  'tutorial.course.arms': 'Dos brazos',
  'tutorial.course.nesting': 'Programas en programas',
  'tutorial.courseOver': 'Este curso ha terminado. Arriba hay otro.',
  'tutorial.open': 'Abrir «{name}»',
  'tutorial.loopSee': 'Vea un bucle que funciona',
  'tutorial.loopSeeHow': 'Ábralo y pulse Ejecutar. Lea las frases de abajo: ¿adónde vuelve, y qué lo decide?',
  'tutorial.twoActions': 'Haga un programa de dos acciones',
  'tutorial.twoActionsHow':
    'Una aplicación nueva de un flujo, por ejemplo «abre la mano» y «cierra la mano». No debe quedar ningún hueco.',
  'tutorial.loop': 'Repítalas',
  'tutorial.loopHow':
    'Seleccione las dos (Mayús + flechas), pulse con el botón derecho y elija «Repetir … veces»: dos.',
  'tutorial.loopRun': 'Ejecútelo y vea cómo vuelve',
  'tutorial.loopRunHow':
    'Pulse Ejecutar. Cuenta cuando la ejecución se completa y una acción del bucle se hizo al menos dos veces.',
  'tutorial.loopWithin': 'Averigüe: ¿cuántas veces se hace lo que está en un bucle dentro de otro?',
  'tutorial.loopWithinHow':
    'Seleccione el bucle entero y repítalo otra vez, dos veces. Diga antes un número; luego ejecútelo y mire las cuentas en los iconos. Cuenta cuando una acción del bucle interior se hizo cuatro veces o más.',
  'tutorial.branchSee': 'Vea una bifurcación que funciona',
  'tutorial.branchSeeHow':
    'Ábrala y pulse Ejecutar. ¿Qué flujo toma, y qué tendría que ocurrir para que tomase el otro?',
  'tutorial.branch': 'Ponga una bifurcación en un programa suyo',
  'tutorial.branchHow': 'Pulse con el botón derecho donde deba estar y elija «Insertar una bifurcación…».',
  'tutorial.branchFlows': 'Dele una condición, y a cada uno de sus flujos una acción',
  'tutorial.branchFlowsHow':
    'Por ejemplo `LAMP == 1` para el primer flujo. Lo más rápido es lo que no necesita objetivo, como «abre la mano».',
  'tutorial.branchRun': 'Ejecútelo y vea qué flujo toma',
  'tutorial.branchRunHow': 'Cuenta cuando la ejecución se completa y se hizo un flujo de la bifurcación y el otro no.',
  'tutorial.branchMiddle': 'Averigüe: haga que una bifurcación de tres flujos tome el del medio',
  'tutorial.branchMiddleHow':
    'Inserte otra bifurcación, de tres flujos con dos condiciones. Decide la primera condición que se cumple; pruebe `GRIP_MEZ[0] < 0.05` detrás de «cierra la mano», y cámbiela hasta que se ejecute el del medio.',
  'tutorial.meetSee': 'Vea dos flujos que se encuentran',
  'tutorial.meetSeeHow':
    'Ábralo y pulse Ejecutar. Dos brazos se apartan y saludan en el mismo instante, tarde lo que tarde cada uno.',
  'tutorial.twoFlows': 'Haga una aplicación de dos flujos en paralelo',
  'tutorial.twoFlowsHow':
    'Una aplicación nueva, dos flujos, paralela; o «Añadir un flujo» debajo del primero. Junto al nombre debe decir «paralela».',
  'tutorial.tags': 'Haga que se esperen',
  'tutorial.tagsHow':
    'Dé a cada flujo acciones de su propio brazo. Pulse con el botón derecho una acción de cada uno, elija «Sincronizar…» y dé a las dos la misma marca.',
  'tutorial.meet': 'Ejecútelo y vea cómo se encuentran',
  'tutorial.meetHow':
    'Cuenta cuando la ejecución se completa y los flujos han empezado juntos en esa marca: una línea que los cruza en la línea de tiempo.',
  'tutorial.meetTwice': 'Averigüe: haga que se encuentren dos veces',
  'tutorial.meetTwiceHow':
    'Una segunda marca, más adelante en los dos. ¿Qué pasa si en uno de los flujos las dos marcas están en el orden contrario? Pruébelo: la página lo dice antes de que nada se mueva. Cuenta cuando una ejecución completa se encontró en dos marcas.',
  'tutorial.armsSee': 'Vea dos brazos trabajando',
  'tutorial.armsSeeHow': 'Ábralo y pulse Ejecutar. Cada flujo mueve un brazo propio, y ninguno espera al otro.',
  'tutorial.armsFlows': 'Haga un programa para los dos brazos',
  'tutorial.armsFlowsHow':
    'Una aplicación nueva de dos flujos, paralela. En uno, «mueve las articulaciones» y un objetivo; en el otro, «mueve las articulaciones del brazo derecho» y un objetivo, como «a la izquierda, lejos de la mesa». No debe quedar ningún hueco.',
  'tutorial.armsRun': 'Ejecútelo y vea cómo se mueven los dos',
  'tutorial.armsRunHow': 'Cuenta cuando la ejecución se completa y los dos brazos han hecho algo.',
  'tutorial.armsWait': 'Averigüe: haga que un brazo empiece solo cuando el otro haya terminado un movimiento',
  'tutorial.armsWaitHow':
    '¿Dónde deben estar las dos marcas? Ponga una en la primera acción del brazo que espera. Cuenta cuando la ejecución se completa y allí siguieron juntos.',
  'tutorial.nestSee': 'Vea un programa hecho de programas',
  'tutorial.nestSeeHow':
    'Ábralo y pulse Ejecutar. Una sola imagen va hasta allí y saluda: es un programa entero, y toma un objetivo.',
  'tutorial.nestInside': 'Mire dentro de uno',
  'tutorial.nestInsideHow':
    'Mantenga Mayús y haga clic en «ve y saluda con los dedos»: al lado se abre de qué está hecho. Su hueco es lo que llena el objetivo.',
  'tutorial.nestUse': 'Úselo en un programa suyo',
  'tutorial.nestUseHow': 'Una aplicación nueva: ponga en ella «ve y saluda con los dedos», y detrás un objetivo.',
  'tutorial.nestRun': 'Ejecútelo también',
  'tutorial.nestRunHow': 'Cuenta cuando la ejecución se completa. Mayús + clic mira dentro mientras se ejecuta.',
  'tutorial.nestOwn': 'Averigüe: haga una imagen de un programa suyo, y úsela',
  'tutorial.nestOwnHow':
    'Guarde un programa y elija «Como icono…» debajo de su nombre. Ponga la imagen nueva en otro programa y ejecútelo. ¿Qué debe dejar abierto para tomar un objetivo?',
}
