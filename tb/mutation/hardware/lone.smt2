; SPDX-License-Identifier: MIT
; One orient2d of four points, or orient3d of five, is never the only one that is not 0: it is a
; sum of the others. Both ends of an edge have the same projection on an axis that is normal to it.
; Each check-sat must say unsat, the last one, with a sign that is wrong, sat.
(set-logic QF_NIA)
(define-fun orient2d ((px Int) (py Int) (qx Int) (qy Int) (rx Int) (ry Int)) Int
  (- (* (- qx px) (- ry py)) (* (- qy py) (- rx px))))
(define-fun orient3d ((px Int) (py Int) (pz Int) (qx Int) (qy Int) (qz Int)
                      (rx Int) (ry Int) (rz Int) (sx Int) (sy Int) (sz Int)) Int
  (+ (* (- qx px) (- (* (- ry py) (- sz pz)) (* (- rz pz) (- sy py))))
     (* (- qy py) (- (* (- rz pz) (- sx px)) (* (- rx px) (- sz pz))))
     (* (- qz pz) (- (* (- rx px) (- sy py)) (* (- ry py) (- sx px))))))
(declare-const px Int) (declare-const py Int) (declare-const pz Int)
(declare-const qx Int) (declare-const qy Int) (declare-const qz Int)
(declare-const rx Int) (declare-const ry Int) (declare-const rz Int)
(declare-const sx Int) (declare-const sy Int) (declare-const sz Int)
(declare-const tx Int) (declare-const ty Int) (declare-const tz Int)
(push)
(assert (distinct (orient2d px py qx qy rx ry)
  (+ (orient2d sx sy qx qy rx ry) (orient2d px py sx sy rx ry) (orient2d px py qx qy sx sy))))
(check-sat)
(pop)
(push)
(assert (distinct (orient3d px py pz qx qy qz rx ry rz sx sy sz)
  (+ (orient3d tx ty tz qx qy qz rx ry rz sx sy sz) (orient3d px py pz tx ty tz rx ry rz sx sy sz)
     (orient3d px py pz qx qy qz tx ty tz sx sy sz)
     (orient3d px py pz qx qy qz rx ry rz tx ty tz))))
(check-sat)
(pop)
; The axis is (q - p) x s.
(define-fun projection ((x Int) (y Int) (z Int)) Int
  (+ (* x (- (* (- qy py) sz) (* (- qz pz) sy))) (* y (- (* (- qz pz) sx) (* (- qx px) sz)))
     (* z (- (* (- qx px) sy) (* (- qy py) sx)))))
(push)
(assert (distinct (projection px py pz) (projection qx qy qz)))
(check-sat)
(pop)
(assert (distinct (orient2d px py qx qy rx ry)
  (- (orient2d sx sy qx qy rx ry) (orient2d px py sx sy rx ry) (orient2d px py qx qy sx sy))))
(check-sat)
